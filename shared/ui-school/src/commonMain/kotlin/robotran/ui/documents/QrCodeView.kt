package robotran.ui.documents

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.role
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.DialogProperties
import robotran.qrcode.QrCode
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import kotlin.math.floor

/**
 * [link] as a QR code for another device, or the reason why there is none.
 *
 * @param help says what to do with it.
 * @param isForClass whether many pupils read it from afar, so that a button says that it can fill the screen; a touch
 * on the code does that in any case.
 * @param maxSide how large it may be here.
 */
@Composable
internal fun LinkAsQrCode(
    link: String,
    help: String = DocumentTexts.qrHelp(spoken),
    isForClass: Boolean = false,
    maxSide: Dp = MAX_SIDE,
) {
    val code = remember(link) { QrCode.of(link) }
    val news = Modifier.announced()
    if (code == null) {
        val words = if (isForClass) SchoolTexts::makeQrLong else DocumentTexts::qrLong
        Explanation(words(spoken), news.testTag(DocumentTags.QR_TOO_LONG))
        return
    }
    if (help.isNotEmpty()) Explanation(help, news)
    var isLarge by remember { mutableStateOf(false) }
    val large = DocumentTexts.qrLarge(spoken)
    Box(Modifier.fillMaxWidth(), Alignment.Center) {
        val side = Modifier.widthIn(max = minOf(maxSide, MAX_SIDE)).fillMaxWidth()
        QrCodeView(code, side.focusRing().clickable(onClickLabel = large) { isLarge = true }, DocumentTags.QR_CODE)
    }
    if (isForClass) Button(large, DocumentTags.QR_SHOW_LARGE, ButtonKind.SECOND) { isLarge = true }
    if (isLarge) LargeQrCode(code) { isLarge = false }
}

/** [code] as large as the screen has room for, on white also at night, as projectors and cameras need it. */
@Composable
internal fun LargeQrCode(code: QrCode, onClose: () -> Unit) =
    DialogWindow(onClose, DialogProperties(usePlatformDefaultWidth = false)) {
        val name = DocumentTexts.qrCode(spoken)
        val close = @Composable {
            Button(
                SchoolTexts.handInClose(spoken),
                DocumentTags.QR_LARGE_CLOSE,
                modifier = Modifier.padding(8.dp),
                onClick = onClose,
            )
        }
        BoxWithConstraints(
            Modifier
                .fillMaxSize()
                .background(RobotranColours.ON_COLOUR)
                .testTag(DocumentTags.QR_LARGE_VIEW)
                .semantics { paneTitle = name },
        ) {
            val isAcross = maxWidth > maxHeight
            // A square as large as possible, whatever the close button leaves.
            val side = if (isAcross) {
                minOf(maxHeight, maxWidth - CLOSE_WIDTH)
            } else {
                minOf(maxWidth, maxHeight - CLOSE_HEIGHT)
            }
            val large = @Composable { QrCodeView(code, Modifier.size(side), DocumentTags.QR_CODE_LARGE) }
            if (isAcross) {
                Row(Modifier.fillMaxSize()) {
                    Box(Modifier.weight(1f).fillMaxHeight(), Alignment.Center) { large() }
                    close()
                }
            } else {
                Column(Modifier.fillMaxSize(), horizontalAlignment = Alignment.End) {
                    close()
                    Box(Modifier.weight(1f).fillMaxWidth(), Alignment.Center) { large() }
                }
            }
        }
    }

@Composable
private fun QrCodeView(code: QrCode, modifier: Modifier, tag: String) {
    val words = DocumentTexts.qrCode(spoken)
    Canvas(
        modifier.aspectRatio(1f).testTag(tag).semantics {
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

/** Room for the button beside or above a large code. */
private val CLOSE_WIDTH = 140.dp
private val CLOSE_HEIGHT = 72.dp
