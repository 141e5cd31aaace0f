@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import kotlinx.coroutines.await
import robotran.workshop.platform.QrScanResult
import robotran.workshop.platform.QrScanner
import robotran.workshop.platform.QrScannerWords
import robotran.workshop.state.QrScannerKind
import kotlin.js.Promise

/** Reads QR codes with the camera. Its view is a dialog of HTML above the canvas, since only HTML shows a camera. */
internal class CameraQrScanner private constructor() : QrScanner {
    override val kinds: List<QrScannerKind> get() = listOf(QrScannerKind.CAMERA)

    override suspend fun scan(kind: QrScannerKind, words: QrScannerWords, onFound: (String) -> Boolean): QrScanResult {
        val controller = newAbortController()
        val error = try {
            scan(wordsFor(words), onFound, controller).await<JsString>().toString()
        } finally {
            abort(controller)
        }
        return when (error) {
            "" -> QrScanResult.Ended
            in NOT_ALLOWED -> QrScanResult.NotAllowed
            in NO_CAMERA -> QrScanResult.NoCamera
            else -> QrScanResult.Failed(error)
        }
    }

    companion object {
        private val NOT_ALLOWED = setOf("NotAllowedError", "SecurityError")
        private val NO_CAMERA = setOf("NotFoundError", "NotReadableError", "OverconstrainedError", "AbortError")

        /** Null where browsers give no camera to a page: in old ones, and over plain `http`. */
        fun find(): QrScanner? = if (hasCameras()) CameraQrScanner() else null
    }
}

private fun hasCameras(): Boolean =
    js("Boolean(navigator.mediaDevices && navigator.mediaDevices.getUserMedia && 'adoptedStyleSheets' in document)")

private fun wordsFor(words: QrScannerWords): JsAny =
    wordsFor(words.title, words.hint, words.starting, words.counted, words.useless, words.done)

private fun wordsFor(
    title: String,
    hint: String,
    starting: String,
    counted: String,
    useless: String,
    done: String,
): JsAny = js("({ title, hint, starting, counted, useless, done })")

private fun newAbortController(): JsAny = js("new AbortController()")

private fun abort(controller: JsAny): Unit = js("controller.abort()")

/** A dynamic import, so that the page loads the module only when it is needed. */
private fun scan(words: JsAny, onFound: (String) -> Boolean, controller: JsAny): Promise<JsString> = js(
    "import(/* webpackChunkName: 'qr-scanner' */ './qr-scanner.mjs')" +
        ".then((module) => module.scan(words, onFound, controller.signal), (error) => String(error))",
)
