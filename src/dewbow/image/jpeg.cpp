// SPDX-License-Identifier: Apache-2.0
#include "dewbow/image/jpeg.h"

#include <cstdio>  // jpeglib.h needs FILE and does not say so

#include <jpeglib.h>

#include <jerror.h>

#include <csetjmp>

#include "dewbow/base/check.h"
#include "dewbow/image/limits.h"
#include "dewbow/image/refuse.h"

// libjpeg reports an error through a callback that must not return; ours longjmps. So that no
// destructor is jumped over, each function that calls setjmp has only trivial locals.

namespace dewbow {
namespace {

/// A progressive file can hold any number of scans, each as slow as a whole picture. Encoders write
/// about ten.
constexpr int kMaxScans = 100;

struct JpegErrors {
    jpeg_error_mgr manager;  // first: libjpeg hands back its address
    std::jmp_buf escape;
    char message[JMSG_LENGTH_MAX] = "";
};

struct JpegProgress {
    jpeg_progress_mgr manager;  // first: libjpeg hands back its address
};

void fail(j_common_ptr codec) {
    auto* errors = reinterpret_cast<JpegErrors*>(codec->err);
    codec->err->format_message(codec, errors->message);
    std::longjmp(errors->escape, 1);
}

/// Level -1 is damage that libjpeg papers over. Stray bytes between segments are common and
/// harmless; pixels that are missing are not.
void take_warning(j_common_ptr codec, int level) {
    const int code = codec->err->msg_code;
    if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER)) fail(codec);
}

void stay_silent(j_common_ptr) {}

void limit_scans(j_common_ptr codec) {
    if (!codec->is_decompressor) return;
    if (reinterpret_cast<j_decompress_ptr>(codec)->input_scan_number > kMaxScans)
        ERREXIT(codec, JERR_BAD_PROGRESSION);
}

struct JpegReader {
    JpegReader() {
        codec.err = jpeg_std_error(&errors.manager);
        errors.manager.error_exit = fail;
        errors.manager.emit_message = take_warning;
        errors.manager.output_message = stay_silent;
        progress.manager.progress_monitor = limit_scans;
    }
    JpegReader(const JpegReader&) = delete;
    ~JpegReader() { jpeg_destroy_decompress(&codec); }

    jpeg_decompress_struct codec{};
    JpegErrors errors{};
    JpegProgress progress{};
};

bool read_jpeg_header(JpegReader& reader, std::string_view bytes) {
    if (setjmp(reader.errors.escape)) return false;
    jpeg_create_decompress(&reader.codec);
    reader.codec.progress = &reader.progress.manager;
    jpeg_mem_src(&reader.codec, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_read_header(&reader.codec, TRUE);
    return true;
}

bool read_jpeg_rows(JpegReader& reader, std::uint8_t* rgb, std::size_t stride) {
    if (setjmp(reader.errors.escape)) return false;
    reader.codec.out_color_space = JCS_RGB;
    // The exact integer transform in every build: textures have the same bits on every machine.
    reader.codec.dct_method = JDCT_ISLOW;
    jpeg_start_decompress(&reader.codec);
    while (reader.codec.output_scanline < reader.codec.output_height) {
        JSAMPROW row = rgb + reader.codec.output_scanline * stride;
        jpeg_read_scanlines(&reader.codec, &row, 1);
    }
    jpeg_finish_decompress(&reader.codec);
    return true;
}

[[noreturn]] void refuse(const JpegReader& reader, const std::string& name) {
    refuse_file(name, std::string("this JPEG file cannot be read: ") + reader.errors.message);
}

}  // namespace

Image8 decode_jpeg(std::string_view bytes, const std::string& name) {
    if (!is_jpeg(bytes)) refuse_file(name, "this is not a JPEG file");
    JpegReader reader;
    if (!read_jpeg_header(reader, bytes)) refuse(reader, name);
    const jpeg_decompress_struct& codec = reader.codec;
    if (codec.jpeg_color_space == JCS_CMYK || codec.jpeg_color_space == JCS_YCCK)
        refuse_file(name, "this JPEG file is in CMYK; save it in RGB");
    check_image_size(name, codec.image_width, codec.image_height, 3, bytes.size());

    Image8 image;
    image.width = static_cast<int>(codec.image_width);
    image.height = static_cast<int>(codec.image_height);
    const std::size_t stride = 3 * static_cast<std::size_t>(image.width);
    image.rgb.resize(stride * static_cast<std::size_t>(image.height));
    if (!read_jpeg_rows(reader, image.rgb.data(), stride)) refuse(reader, name);
    return image;
}

bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); }

}  // namespace dewbow
