package robotran.ui.brick.rcx

import androidx.compose.foundation.Canvas
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.messages.describe
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.uikit.*

/** The display, segment by segment. Screen readers announce its text and icons on every change. */
@Composable
internal fun LcdView(glass: LcdGlass, modifier: Modifier = Modifier) {
    Canvas(modifier.describing(glass)) { drawLcd(glass) }
}

/** The same display, cropped to its row of digits. */
@Composable
internal fun LcdNumbers(glass: LcdGlass, modifier: Modifier = Modifier) {
    Canvas(modifier.describing(glass)) { drawLcdNumbers(glass) }
}

@Composable
private fun Modifier.describing(glass: LcdGlass): Modifier {
    val shown = glass.describe(BrickMessages.of(LocalLanguage.current))
    val description = if (glass == LcdGlass.BLANK) {
        RunTexts.displayBlank(spoken)
    } else {
        RunTexts.display(spoken, shown)
    }
    return testTag(RunTags.LCD).semantics {
        contentDescription = description
        liveRegion = LiveRegionMode.Polite
    }
}
