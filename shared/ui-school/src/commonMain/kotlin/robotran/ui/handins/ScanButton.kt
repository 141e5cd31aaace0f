package robotran.ui.handins

import androidx.compose.runtime.Composable
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.platform.QrScannerWords
import robotran.workshop.state.QrScannerKind

/** Reads QR codes with hand-ins, as the platform can. */
@Composable
internal fun ScanButton(kind: QrScannerKind, onEvent: (HandInsEvent) -> Unit) {
    val label = when (kind) {
        QrScannerKind.CAMERA -> SchoolTexts.handInsScan(spoken)
        QrScannerKind.PHOTO -> SchoolTexts.handInsScanPhoto(spoken)
        QrScannerKind.PICTURES -> SchoolTexts.handInsScanPictures(spoken)
    }
    val words = QrScannerWords(
        title = SchoolTexts.handInsScan(spoken),
        hint = SchoolTexts.handInsScanHint(spoken),
        starting = SchoolTexts.handInsScanStarting(spoken),
        counted = SchoolTexts.handInsScanCounted(spoken, "%1\$d"),
        useless = SchoolTexts.handInsScanUseless(spoken),
        done = SchoolTexts.handInsScanDone(spoken),
    )
    val tag = if (kind == QrScannerKind.PICTURES) HandInTags.HAND_INS_SCAN_PICTURES else HandInTags.HAND_INS_SCAN
    Button(label, tag, ButtonKind.SECOND) { onEvent(HandInsEvent.ScanRequested(kind, words)) }
}
