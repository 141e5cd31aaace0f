package robotran.ui.documents

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import kotlin.math.floor
import org.jetbrains.compose.resources.stringResource
import robotran.qrcode.QrCode
import robotran.ui.resources.Res
import robotran.ui.resources.documents_qr_code
import robotran.ui.resources.documents_qr_help
import robotran.ui.resources.documents_qr_long
import robotran.ui.theme.RobotranColours

/** [link] as a QR code for another device, or the reason why there is none. [help] says what to do with it. */
@Composable
internal fun LinkAsQrCode(
    link: String,
    help: String = stringResource(Res.string.documents_qr_help),
    maxHeight: Dp = Dp.Infinity,
) {
    val code = remember(link) { QrCode.of(link) }
    if (code == null) {
        Explanation(stringResource(Res.string.documents_qr_long), Modifier.testTag("qr-too-long"))
        return
    }
    Explanation(help)
    Box(Modifier.fillMaxWidth(), Alignment.Center) { QrCodeView(code, minOf(maxHeight, MAX_SIDE)) }
}

@Composable
private fun QrCodeView(code: QrCode, maxSide: Dp) {
    val words = stringResource(Res.string.documents_qr_code)
    Canvas(
        Modifier.widthIn(max = maxSide).fillMaxWidth().aspectRatio(1f).testTag("qr-code").semantics {
            role = Role.Image
            contentDescription = words
        },
    ) { drawQrCode(code) }
}

/** Dark on light in every theme, as cameras need it, with a whole number of pixels per module. */
private fun DrawScope.drawQrCode(code: QrCode) {
    drawRect(RobotranColours.ON_COLOUR)
    val module = floor(size.width / (code.size + 2 * QrCode.MARGIN)).coerceAtLeast(1f)
    val start = floor((size.width - module * code.size) / 2)
    for (row in 0..<code.size) {
        var column = 0
        while (column < code.size) {
            val from = column
            while (column < code.size && code.isDark(column, row)) column++
            drawRect(
                RobotranColours.SHADE,
                Offset(start + from * module, start + row * module),
                Size((column - from) * module, module),
            )
            column++
        }
    }
}

private val MAX_SIDE = 360.dp
