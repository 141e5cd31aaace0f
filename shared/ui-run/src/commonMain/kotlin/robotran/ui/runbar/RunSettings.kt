package robotran.ui.runbar

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.input.KeyboardType
import androidx.compose.ui.unit.dp
import robotran.projects.ProjectSettings
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.BrickLabels
import robotran.uikit.*
import robotran.workshop.event.RunEvent
import robotran.workshop.state.RunPaneState
import kotlin.math.roundToInt

/** The robot's precision, the random seed, and the Java options; every change starts a new run. */
@Composable
internal fun RunSettings(state: RunPaneState, onEvent: (RunEvent) -> Unit) {
    val settings = state.settings

    fun change(to: ProjectSettings) = onEvent(RunEvent.RunSettingsChanged(to))
    Column(verticalArrangement = Arrangement.spacedBy(20.dp)) {
        Realism(state.world.realism) { change(settings.copy(realism = it)) }
        Seed(state.world.seed) { change(settings.copy(seed = it)) }
        Column {
            SectionName(RunTexts.java(spoken))
            val brick = state.world.robots[state.watched].description.brick
            Setting(
                RunTexts::javaForgiving,
                BrickLabels.of(brick).forgivingJava,
                RunTags.JAVA_FORGIVING,
                settings.java.mode == TinyVmMode.FORGIVING,
            ) {
                change(
                    settings.copy(
                        java = settings.java.copy(mode = if (it) TinyVmMode.FORGIVING else TinyVmMode.BRICK),
                    ),
                )
            }
            Setting(
                RunTexts::javaFast,
                RunTexts::javaFastHelp,
                RunTags.JAVA_FAST,
                settings.java.speed == TinyVmSpeed.UNLIMITED,
            ) {
                change(
                    settings.copy(
                        java = settings.java.copy(speed = if (it) TinyVmSpeed.UNLIMITED else TinyVmSpeed.BRICK),
                    ),
                )
            }
        }
    }
}

@Composable
private fun Realism(realism: Double, onRealism: (Double) -> Unit) {
    var wanted by remember(realism) { mutableFloatStateOf(realism.toFloat()) }
    val name = RunTexts.realism(spoken)
    val value = RunTexts.realismValue(spoken, (wanted * PER_CENT).roundToInt())
    Column {
        SectionName("$name: $value")
        Slider(
            wanted,
            SliderWords(name, value, RunTags.REALISM),
            steps = REALISM_STEPS - 1,
            onSettle = { onRealism((wanted * REALISM_STEPS).roundToInt() / REALISM_STEPS.toDouble()) },
        ) { wanted = it }
        Help(RunTexts::realismHelp)
    }
}

@Composable
private fun Seed(seed: Int, onSeed: (Int) -> Unit) {
    var written by remember(seed) { mutableStateOf(seed.toString()) }
    val name = RunTexts.seed(spoken)
    Column {
        SectionName(name)
        Row(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalAlignment = Alignment.CenterVertically) {
            TextField(
                written,
                { text ->
                    written = text.filter { it in '0'..'9' }.take(MAX_DIGITS)
                    written.toIntOrNull()?.takeIf { it != seed }?.let(onSeed)
                },
                Modifier.width(160.dp).testTag(RunTags.SEED).named(name),
                keyboard = KeyboardOptions(keyboardType = KeyboardType.Number),
            )
            IconButton(RunIcons.NEXT, RunTexts.seedNext(spoken), RunTags.SEED_NEXT, IconButtonKind.RUN) {
                onSeed(
                    if (seed == Int.MAX_VALUE) {
                        1
                    } else {
                        seed + 1
                    },
                )
            }
        }
        Help(RunTexts::seedHelp)
    }
}

@Composable
private fun Setting(name: Label, help: Label, tag: String, on: Boolean, onSwitch: (Boolean) -> Unit) {
    Row(
        Modifier
            .testTag(tag)
            .focusRing()
            .toggleable(on, role = Role.Switch, onValueChange = onSwitch)
            .fillMaxWidth()
            .defaultMinSize(minHeight = Dimensions.TARGET),
        horizontalArrangement = Arrangement.spacedBy(12.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Column(Modifier.weight(1f)) { Choice(name(spoken), help(spoken)) }
        SwitchMark(on)
    }
}

@Composable
private fun Help(text: Label) {
    Text(text(spoken), Modifier.padding(top = 4.dp), TextStyles.caption, color = LocalRobotranColours.current.quiet)
}

private const val REALISM_STEPS = 10
private const val PER_CENT = 100

/** So that every number fits a seed. */
private const val MAX_DIGITS = 9
