package robotran.uikit

import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.ExperimentalMaterial3Api
import androidx.compose.material3.PrimaryScrollableTabRow
import androidx.compose.material3.PrimaryTabRow
import androidx.compose.material3.TabIndicatorScope
import androidx.compose.material3.TabRowDefaults
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.material3.Tab as MaterialTab

/** One of several [Tabs], with a sign if it [isMarked] for something wrong in it. */
class Tab(val name: String, val tag: String, val isMarked: Boolean = false)

/** The names of panes, of which one is [chosen]; null if none is. With large text they scroll. */
@OptIn(ExperimentalMaterial3Api::class)
@Composable
fun Tabs(tabs: List<Tab>, chosen: Int?, modifier: Modifier = Modifier, onChoose: (Int) -> Unit) {
    val colours = LocalRobotranColours.current
    val indicator: @Composable TabIndicatorScope.() -> Unit = {
        if (chosen != null) {
            TabRowDefaults.PrimaryIndicator(Modifier.tabIndicatorOffset(chosen), color = colours.onPane, width = 56.dp)
        }
    }
    val all: @Composable () -> Unit = {
        tabs.forEachIndexed { place, tab -> OneTab(tab, place == chosen) { onChoose(place) } }
    }
    if (LocalDensity.current.fontScale > LARGE) {
        PrimaryScrollableTabRow(
            selectedTabIndex = chosen ?: 0,
            modifier = modifier,
            containerColor = colours.pane,
            contentColor = colours.onPane,
            edgePadding = 0.dp,
            indicator = indicator,
            divider = { },
            tabs = all,
        )
    } else {
        PrimaryTabRow(chosen ?: 0, modifier, colours.pane, colours.onPane, indicator, { }, all)
    }
}

@Composable
private fun OneTab(tab: Tab, chosen: Boolean, onChoose: () -> Unit) {
    val colours = LocalRobotranColours.current
    MaterialTab(
        selected = chosen,
        onClick = onChoose,
        modifier = Modifier.testTag(tab.tag).defaultMinSize(minHeight = Dimensions.TARGET).focusRing(),
        selectedContentColor = if (tab.isMarked) colours.error else colours.onPane,
        unselectedContentColor = if (tab.isMarked) colours.error else colours.quiet,
    ) {
        Text(
            if (tab.isMarked) "!\u00A0${tab.name}" else tab.name,
            Modifier.padding(horizontal = 4.dp),
            TextStyles.compact.strong,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
    }
}

/** Up to this font scale, three names fit on a phone. */
private const val LARGE = 1.3f
