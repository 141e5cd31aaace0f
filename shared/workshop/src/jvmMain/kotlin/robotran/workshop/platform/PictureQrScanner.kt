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
 * Reads QR codes in pictures that the user chooses.
 *
 * @param pixelsIn decodes a picture file; null if it is none.
 * @param background where that takes place.
 */
class PictureQrScanner(
    private val files: FilePicker,
    private val background: CoroutineContext,
    private val pixelsIn: (ByteArray) -> Pixels?,
) : QrScanner {
    override val kind: QrScannerKind get() = QrScannerKind.PICTURES

    override suspend fun scan(words: QrScannerWords, onFound: (String) -> Boolean): QrScanResult {
        val chosen = files.open(listOf(FileKind.JPEG, FileKind.LONG_JPEG, FileKind.PNG))
        if (chosen.isEmpty()) return QrScanResult.Ended
        val texts = withContext(background) { chosen.flatMap { pixelsIn(it.bytes)?.let(::qrCodesIn).orEmpty() } }
        if (texts.isEmpty()) return QrScanResult.NoCodes
        texts.distinct().forEach { onFound(it) }
        return QrScanResult.Ended
    }
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
