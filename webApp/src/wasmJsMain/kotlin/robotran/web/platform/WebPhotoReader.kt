@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import kotlinx.coroutines.await
import robotran.workshop.platform.Photo
import robotran.workshop.platform.PhotoReader
import kotlin.io.encoding.Base64
import kotlin.js.Promise

/** Reads photos with the browser, which decodes them beside the page's thread and turns them upright. */
internal object WebPhotoReader : PhotoReader {
    override suspend fun read(bytes: ByteArray): Photo? =
        decode(Base64.encode(bytes)).await<ImageBitmap?>()?.let(::WebPhoto)
}

private class WebPhoto(private val picture: ImageBitmap) : Photo {
    override val width: Int get() = picture.width
    override val height: Int get() = picture.height

    override suspend fun jpeg(width: Int, height: Int, quality: Int): ByteArray =
        Base64.decode(jpegOf(picture, width, height, quality / PERCENT).await<JsString>().toString())

    override fun close() = picture.close()

    private companion object {
        const val PERCENT = 100.0
    }
}

/** The browser's decoded picture. */
private external interface ImageBitmap : JsAny {
    val width: Int
    val height: Int

    fun close()
}

private fun decode(content: String): Promise<ImageBitmap?> = js(
    """createImageBitmap(new Blob([Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0))]))
        .catch(() => null)""",
)

/** The file in Base64, after the address's head. */
private fun jpegOf(picture: ImageBitmap, width: Int, height: Int, quality: Double): Promise<JsString> = js(
    """new Promise((resolve) => {
        const canvas = document.createElement('canvas');
        canvas.width = width;
        canvas.height = height;
        const context = canvas.getContext('2d');
        context.fillStyle = '#fff';
        context.fillRect(0, 0, width, height);
        context.imageSmoothingQuality = 'high';
        context.drawImage(picture, 0, 0, width, height);
        canvas.toBlob((file) => {
            const reader = new FileReader();
            reader.addEventListener('load', () => resolve(reader.result.split(',')[1]));
            reader.readAsDataURL(file);
        }, 'image/jpeg', quality);
    })""",
)
