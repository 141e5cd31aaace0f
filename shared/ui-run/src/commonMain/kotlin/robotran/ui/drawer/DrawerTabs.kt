package robotran.ui.drawer

import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.selection.selectable
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.runbar.word
import robotran.uikit.*
import robotran.workshop.state.DrawerTab

/** The tabs over the drawer's content on a whole pane. The [open] one is underlined, and a touch on it closes it. */
@Composable
internal fun DrawerTabs(open: DrawerTab, onTab: (DrawerTab?) -> Unit, modifier: Modifier = Modifier) {
    TabRow(open, RunTags.DRAWER, { onTab(if (it == open) null else it) }, modifier) {
        IconButton(RunIcons.DOWN, RunTexts.drawerClose(spoken), RunTags.DRAWER_CLOSE, IconButtonKind.RUN) {
            onTab(null)
        }
    }
}

/** The same tabs below the drawer, which stay where they are while it opens and closes; null if it is closed. */
@Composable
fun FootTabs(open: DrawerTab?, onTab: (DrawerTab?) -> Unit, modifier: Modifier = Modifier) =
    TabRow(open, RunTags.DRAWER, { onTab(if (it == open) null else it) }, modifier, isSteady = true) { }

/** The name of the open [tab] over its content. With [onTwo] a second one can open next to it. */
@Composable
internal fun DrawerHead(tab: DrawerTab, onClose: () -> Unit, onTwo: (() -> Unit)? = null) {
    Row(Modifier.padding(horizontal = 8.dp), verticalAlignment = Alignment.CenterVertically) {
        Text(
            tab.word(spoken),
            Modifier.weight(1f).padding(start = 8.dp).heading(),
            TextStyles.compact.strong,
            maxLines = 1,
        )
        if (onTwo != null) {
            IconButton(
                RunIcons.TWO,
                RunTexts.drawerTwo(spoken),
                RunTags.DRAWER_TWO,
                IconButtonKind.RUN,
                onClick = onTwo,
            )
        }
        IconButton(
            RunIcons.DOWN,
            RunTexts.drawerClose(spoken),
            RunTags.DRAWER_CLOSE,
            IconButtonKind.RUN,
            onClick = onClose,
        )
    }
}

/** The tabs above the second view; null closes only that view. */
@Composable
internal fun BesideTabs(open: DrawerTab, onTab: (DrawerTab?) -> Unit, modifier: Modifier = Modifier) {
    TabRow(open, RunTags.BESIDE, { onTab(if (it == open) null else it) }, modifier) {
        IconButton(RunIcons.CLOSE, RunTexts.drawerOne(spoken), RunTags.BESIDE_CLOSE, IconButtonKind.RUN) { onTab(null) }
    }
}

@Composable
private fun TabRow(
    open: DrawerTab?,
    tag: String,
    onTab: (DrawerTab) -> Unit,
    modifier: Modifier,
    isSteady: Boolean = false,
    buttons: @Composable () -> Unit,
) {
    val scroll = rememberScrollState()
    BoxWithConstraints(modifier.fillMaxWidth().padding(horizontal = 8.dp)) {
        val isSlim = maxWidth < SLIM
        Row(verticalAlignment = Alignment.CenterVertically) {
            Row(
                Modifier
                    .weight(1f)
                    .testTag(RunTags.names(tag))
                    .scrollHint(scroll, Orientation.Horizontal)
                    .horizontalScroll(scroll),
                Arrangement.spacedBy(if (isSlim) 0.dp else 4.dp),
            ) {
                for (tab in DrawerTab.entries) {
                    TabName(tab, tag, tab == open, if (isSlim) 6.dp else 12.dp, isSteady) {
                        onTab(tab)
                    }
                }
            }
            buttons()
        }
    }
}

@Composable
private fun TabName(
    tab: DrawerTab,
    tag: String,
    selected: Boolean,
    inset: Dp,
    isSteady: Boolean,
    onClick: () -> Unit,
) {
    val colours = LocalRobotranColours.current
    Box(
        Modifier
            .testTag(RunTags.tab(tag, tab))
            .broughtIntoSight(selected)
            .focusRing(8.dp)
            .clip(Shapes.SMALL)
            .selectable(selected, role = Role.Tab, onClick = onClick)
            .defaultMinSize(Dimensions.TARGET, Dimensions.TARGET)
            .drawBehind {
                if (!selected) return@drawBehind
                val height = 4.dp.toPx()
                val bar = Size(size.width - 2 * inset.toPx(), height)
                drawRoundRect(
                    RobotranColours.YELLOW,
                    Offset(inset.toPx(), size.height - height),
                    bar,
                    CornerRadius(height / 2),
                )
            }
            .padding(horizontal = inset),
        Alignment.Center,
    ) {
        // The selected name is wider: tabs that stay shall not move.
        SteadySize(selected, if (isSteady) listOf(true, false) else emptyList()) {
            Text(
                tab.word(spoken),
                style = TextStyles.compact.strongIf(it, FontWeight.Medium),
                color = if (it) colours.onPane else colours.quiet,
                maxLines = 1,
            )
        }
    }
}

/** Below this width the tabs are closer together. */
private val SLIM = 480.dp
