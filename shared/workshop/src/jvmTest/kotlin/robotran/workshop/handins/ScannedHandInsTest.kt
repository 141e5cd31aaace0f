package robotran.workshop.handins

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.awaitCancellation
import kotlinx.coroutines.test.advanceUntilIdle
import robotran.workshop.event.HandInsEvent
import robotran.workshop.platform.QrScanResult
import robotran.workshop.platform.QrScanner
import robotran.workshop.platform.QrScannerWords
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.QrScannerKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse

/** Tests how QR codes become hand-ins. */
@OptIn(ExperimentalCoroutinesApi::class)
internal class ScannedHandInsTest : HandInsTesting() {
    @Test
    fun `QR codes come in like links, and a camera that is not there is told`() {
        val results = ArrayDeque(listOf(QrScanResult.Ended, QrScanResult.NoCamera))
        var texts = emptyList<String>()
        val useful = mutableListOf<Boolean>()
        scanner = scannerOf(listOf(QrScannerKind.CAMERA)) { onFound ->
            useful += texts.map(onFound)
            results.removeFirst()
        }
        looking { workshop ->
            assertEquals(listOf(QrScannerKind.CAMERA), workshop.page.scanners)
            texts =
                listOf(
                    "hello",
                    link(AnyClass.handIn("Gabi", AnyClass.solved)),
                    link(AnyClass.handIn("Hans", AnyClass.short)),
                )
            val event = HandInsEvent.ScanRequested(QrScannerKind.CAMERA, NO_WORDS)
            workshop.handle(event)
            advanceUntilIdle()
            assertEquals(listOf(false, true, true), useful)
            assertEquals(listOf("Gabi", "Hans"), workshop.names)
            texts = emptyList()
            workshop.handle(event)
            advanceUntilIdle()
            assertEquals(HandInsMessage.NoCamera, workshop.page.message)
        }
    }

    @Test
    fun `ending the scan closes the view of the scanner`() {
        var isOpen = false
        scanner = scannerOf(listOf(QrScannerKind.CAMERA)) {
            try {
                isOpen = true
                awaitCancellation()
            } finally {
                isOpen = false
            }
        }
        looking { workshop ->
            workshop.handle(HandInsEvent.ScanRequested(QrScannerKind.CAMERA, NO_WORDS))
            advanceUntilIdle()
            assertEquals(listOf(true, true), listOf(isOpen, workshop.page.isScanning))
            workshop.handle(HandInsEvent.ScanEnded)
            advanceUntilIdle()
            assertEquals(listOf(false, false), listOf(isOpen, workshop.page.isScanning))
            workshop.handle(HandInsEvent.ScanRequested(QrScannerKind.CAMERA, NO_WORDS))
            advanceUntilIdle()
            workshop.handle(HandInsEvent.Closed)
            advanceUntilIdle()
            assertFalse(isOpen)
        }
    }

    @Test
    fun `a photo without a code is told otherwise than pictures without one`() {
        scanner = scannerOf(listOf(QrScannerKind.PHOTO, QrScannerKind.PICTURES)) { QrScanResult.NoCodes }
        looking { workshop ->
            for (kind in QrScannerKind.entries.drop(1)) {
                workshop.handle(HandInsEvent.ScanRequested(kind, NO_WORDS))
                advanceUntilIdle()
                assertEquals(HandInsMessage.NoCodes(isPhoto = kind == QrScannerKind.PHOTO), workshop.page.message)
            }
        }
    }

    /** A scanner for [ways] that does [result] with each request. */
    private fun scannerOf(ways: List<QrScannerKind>, result: suspend (onFound: (String) -> Boolean) -> QrScanResult) =
        object : QrScanner {
            override val kinds = ways

            override suspend fun scan(
                kind: QrScannerKind,
                words: QrScannerWords,
                onFound: (String) -> Boolean,
            ): QrScanResult = result(onFound)
        }

    private companion object {
        val NO_WORDS = QrScannerWords("", "", "", "", "", "")
    }
}
