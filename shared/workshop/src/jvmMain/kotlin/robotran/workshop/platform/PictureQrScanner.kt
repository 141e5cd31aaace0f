package robotran.workshop.platform

import com.google.zxing.BinaryBitmap
import com.google.zxing.DecodeHintType
import com.google.zxing.NotFoundException
import com.google.zxing.RGBLuminanceSource
import com.google.zxing.common.HybridBinarizer
import com.google.zxing.multi.qrcode.QRCodeMultiReader
import kotlinx.coroutines.withContext
import robotran.documents.FileKind
import robotran.workshop.state.QrScannerKind
import kotlin.coroutines.CoroutineContext

/**
 * Reads QR codes in pictures that the user chooses, or takes with the camera app of the device.
 *
 * @param pixelsIn decodes a picture file; null if it is none.
 * @param background where that takes place.
 * @param photos null where there is no camera app.
 */
class PictureQrScanner(
    private val files: FilePicker,
    private val background: CoroutineContext,
    private val photos: PhotoTaker? = null,
    private val pixelsIn: (ByteArray) -> Pixels?,
) : QrScanner {
    override val kinds: List<QrScannerKind>
        get() = listOfNotNull(QrScannerKind.PHOTO.takeIf { photos?.isThere == true }, QrScannerKind.PICTURES)

    override suspend fun scan(kind: QrScannerKind, words: QrScannerWords, onFound: (String) -> Boolean): QrScanResult {
        val pictures = if (kind == QrScannerKind.PHOTO && photos != null) {
            when (val photo = photos.take()) {
                is PhotoResult.Taken -> listOf(photo.bytes)
                PhotoResult.Cancelled -> emptyList()
                PhotoResult.NoCamera -> return QrScanResult.NoCamera
            }
        } else {
            files.open(listOf(FileKind.JPEG, FileKind.LONG_JPEG, FileKind.PNG)).map { it.bytes }
        }
        if (pictures.isEmpty()) return QrScanResult.Ended
        val texts = withContext(background) { pictures.flatMap { pixelsIn(it)?.let(::qrCodesIn).orEmpty() } }
        if (texts.isEmpty()) return QrScanResult.NoCodes
        texts.distinct().forEach { onFound(it) }
        return QrScanResult.Ended
    }
}

/** Lets the user take a picture. */
interface PhotoTaker {
    /** Whether the device has an app for it. */
    val isThere: Boolean

    /** Waits until the user has taken a picture, or has given up. */
    suspend fun take(): PhotoResult
}

/** The result of [PhotoTaker.take]. */
sealed interface PhotoResult {
    /** [bytes] are those of a picture file. */
    class Taken(val bytes: ByteArray) : PhotoResult

    data object Cancelled : PhotoResult

    /** The app for it does not open. */
    data object NoCamera : PhotoResult
}

/** A picture; each of [colours] is `0xAARRGGBB`, row by row. */
class Pixels(val width: Int, val height: Int, val colours: IntArray)

/** The texts of all QR codes in [pixels]. */
fun qrCodesIn(pixels: Pixels): List<String> = try {
    val luminance = RGBLuminanceSource(pixels.width, pixels.height, pixels.colours)
    val hints = mapOf(DecodeHintType.TRY_HARDER to true)
    QRCodeMultiReader().decodeMultiple(BinaryBitmap(HybridBinarizer(luminance)), hints).map { it.text }
} catch (_: NotFoundException) {
    emptyList()
}
