package robotran.ui.screen

import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.ExperimentalMaterial3Api
import androidx.compose.material3.PrimaryScrollableTabRow
import androidx.compose.material3.PrimaryTabRow
import androidx.compose.material3.Tab
import androidx.compose.material3.TabIndicatorScope
import androidx.compose.material3.TabRowDefaults
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import robotran.ui.texts.ScreenTexts
import robotran.uikit.*
import robotran.workshop.state.Pane

/**
 * The tabs of the three panes of a narrow screen. [mistaken] marks the program's tab. With large text the tabs scroll.
 */
@OptIn(ExperimentalMaterial3Api::class)
@Composable
internal fun PaneTabs(chosen: Pane, mistaken: Boolean, onChoose: (Pane) -> Unit, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val indicator: @Composable TabIndicatorScope.() -> Unit = {
        TabRowDefaults.PrimaryIndicator(
            Modifier.tabIndicatorOffset(chosen.ordinal),
            color = colours.onPane,
            width = 56.dp,
        )
    }
    val tabs: @Composable () -> Unit = {
        for (pane in Pane.entries) PaneTab(pane, pane == chosen, pane == Pane.PROGRAM && mistaken) { onChoose(pane) }
    }
    if (LocalDensity.current.fontScale > LARGE) {
        PrimaryScrollableTabRow(
            selectedTabIndex = chosen.ordinal,
            modifier = modifier,
            containerColor = colours.pane,
            contentColor = colours.onPane,
            edgePadding = 0.dp,
            indicator = indicator,
            divider = { },
            tabs = tabs,
        )
    } else {
        PrimaryTabRow(chosen.ordinal, modifier, colours.pane, colours.onPane, indicator, { }, tabs)
    }
}

@Composable
private fun PaneTab(pane: Pane, chosen: Boolean, marked: Boolean, onChoose: () -> Unit) {
    val colours = LocalRobotranColours.current
    Tab(
        selected = chosen,
        onClick = onChoose,
        modifier = Modifier.testTag(
            "tab-${pane.name.lowercase()}",
        ).defaultMinSize(minHeight = Dimensions.TARGET).focusRing(),
        selectedContentColor = if (marked) colours.error else colours.onPane,
        unselectedContentColor = if (marked) colours.error else colours.quiet,
    ) {
        val name = pane.title(spoken)
        val words = if (marked) "!\u00A0$name" else name
        val beside = Modifier.padding(horizontal = 4.dp)
        Text(
            words,
            beside,
            fontSize = TextSizes.COMPACT,
            fontWeight = FontWeight.SemiBold,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
    }
}

/** Up to this font scale, three names fit on a phone. */
private const val LARGE = 1.3f

private val Pane.title: Label
    get() = when (this) {
        Pane.PROGRAM -> ScreenTexts::tabProgram
        Pane.WORLD -> ScreenTexts::tabWorld
        Pane.BRICK -> ScreenTexts::tabBrick
    }
