package robotran.ui.handins

import androidx.compose.runtime.Composable
import org.jetbrains.compose.resources.stringResource
import robotran.ui.parts.SecondButton
import robotran.ui.resources.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.platform.QrScannerWords
import robotran.workshop.state.QrScannerKind

/** Reads QR codes with hand-ins, as the platform can. */
@Composable
internal fun ScanButton(kind: QrScannerKind, onEvent: (HandInsEvent) -> Unit) {
    val label = stringResource(
        when (kind) {
            QrScannerKind.CAMERA -> Res.string.hand_ins_scan
            QrScannerKind.PHOTO -> Res.string.hand_ins_scan_photo
            QrScannerKind.PICTURES -> Res.string.hand_ins_scan_pictures
        },
    )
    val words = QrScannerWords(
        title = stringResource(Res.string.hand_ins_scan),
        hint = stringResource(Res.string.hand_ins_scan_hint),
        starting = stringResource(Res.string.hand_ins_scan_starting),
        counted = stringResource(Res.string.hand_ins_scan_counted),
        useless = stringResource(Res.string.hand_ins_scan_useless),
        done = stringResource(Res.string.hand_ins_scan_done),
    )
    val tag = if (kind == QrScannerKind.PICTURES) "hand-ins-scan-pictures" else "hand-ins-scan"
    SecondButton(label, tag, { onEvent(HandInsEvent.ScanRequested(kind, words)) })
}
