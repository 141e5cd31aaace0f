package robotran.uikit.preview

import androidx.compose.desktop.ui.tooling.preview.Preview
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.unit.dp
import robotran.uikit.*

/** One of each control in the light and in the dark theme, as docs/design.md shows them. */
@Preview
@Composable
fun ControlsPreview() = Row {
    for (colours in listOf(RobotranColours.LIGHT, RobotranColours.DARK)) {
        KitTheme(colours) {
            Box(Modifier.width(380.dp).fillMaxHeight().background(colours.pane).padding(Space.LARGE)) { Controls { } }
        }
    }
}

/** One of each control, which passes its tag to [onPress]. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun Controls(onPress: (String) -> Unit) = Column(
    Modifier.verticalScroll(rememberScrollState()),
    Arrangement.spacedBy(Space.SMALL),
) {
    FlowRow(Modifier, Arrangement.spacedBy(Space.SMALL), Arrangement.spacedBy(Space.SMALL)) {
        for (kind in ButtonKind.entries) {
            val name = kind.name.lowercase()
            val tag = "button-$name"
            Button(name.replace('_', ' '), tag, kind) { onPress(tag) }
        }
        Button("disabled", "disabled", enabled = false) { onPress("disabled") }
        BarButton(RunIcons.PLAY, BarWords("Run", "Runs it"), "bar", room = false) { onPress("bar") }
    }
    FlowRow(Modifier, Arrangement.spacedBy(Space.SMALL), Arrangement.spacedBy(Space.SMALL)) {
        for (kind in IconButtonKind.entries) {
            val tag = "icon-${kind.name.lowercase()}"
            IconButton(Icon.MENU, "Menu", tag, kind) { onPress(tag) }
        }
        IconButton(ThinIcons.UNDO, "Undo", "disabled-icon", IconButtonKind.TOOL, enabled = false) { onPress("no") }
        IconSwitch(Icon.BOOK, "Book", "icon-switch", on = false) { onPress("icon-switch") }
        IconWord(EditIcons.COPY, "Copy", "icon-word", { onPress("icon-word") })
    }
    FlowRow(Modifier, Arrangement.spacedBy(Space.SMALL), Arrangement.spacedBy(Space.SMALL)) {
        Chip("All", true, "chip") { onPress("chip") }
        SmallChip("Aa", false, "small-chip", Color.Unspecified) { onPress("small-chip") }
        DialogButton("7", "key") { onPress("key") }
    }
    ChipRow("Side", listOf(1 to "left", 2 to "right"), 1, "side") { onPress("side-${it - 1}") }
    ChoiceOfOne("Theme", listOf(1 to "light", 2 to "dark"), 1, "theme") { onPress("theme-${it - 1}") }
    SwitchRow("Sound", true, "switch-row") { onPress("switch-row") }
    Tabs(listOf(Tab("Program", "tab-0"), Tab("World", "tab-1")), 0) { onPress("tab-$it") }
    Slider(0.5f, SliderWords("Speed", "half", "slider")) { }
    TextField("square", { }, label = "Name")
    CompactField("20", FieldWords("Distance", "compact-field")) { }
    NoticeFrame(NoticeWords("Saved.", false, "Close"), NoticeTags("notice", "notice-text", "close"), {
        onPress("close")
    })
    Progress({ 0.4f }, Modifier.fillMaxWidth())
    CardButton("card", { onPress("card") }) {
        Column(Modifier.padding(Space.LARGE)) {
            Text("Square", style = TextStyles.cardTitle.strong)
            Text("Draws a square", style = TextStyles.smallLines, color = LocalRobotranColours.current.quiet)
        }
    }
}
