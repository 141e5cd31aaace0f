package robotran.ui.robot

import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotItem
import robotran.ui.editing.EditorPalette
import robotran.ui.editing.PaletteButton
import robotran.ui.editing.PaletteLook
import robotran.ui.editing.stretched
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*

/** The palette of the robot's brick. */
@Composable
internal fun RobotPalette(
    scope: RobotScope,
    view: PlanView,
    columns: Int?,
    onPut: () -> Unit,
    modifier: Modifier = Modifier,
) {
    val items: List<@Composable () -> Unit> = RobotItem.of(scope.robot.brick).map { item ->
        @Composable { ItemButton(scope, view, item, columns != null, onPut) }
    }
    EditorPalette(WorldTags.ROBOT_PALETTE, columns, items, modifier)
}

@Composable
private fun ItemButton(scope: RobotScope, view: PlanView, item: RobotItem, upright: Boolean, onPut: () -> Unit) {
    val word = itemWord(item)(spoken)
    val width = stretched(ITEM_WIDTH)
    val lettering = letteringOf(word, width - SIGN_PADDING * 2)
    val look = PaletteLook(word, WorldTags.robotItem(item), width, lettering) { drawRobotItem(item, it) }
    PaletteButton(look, view, upright) { place ->
        scope.make(RobotEdit.Add(item, place?.let(view.transform::toRobot)))
        onPut()
    }
}

@Composable
private fun letteringOf(word: String, width: Dp): SignLettering {
    val measurer = rememberTextMeasurer()
    val style = TextStyles.sign.asWritten()
    val density = LocalDensity.current
    return remember(word, width, style, density, measurer) {
        measurer.signLettering(word, style, with(density) { width.roundToPx() })
    }
}

private val ITEM_WIDTH = 108.dp
