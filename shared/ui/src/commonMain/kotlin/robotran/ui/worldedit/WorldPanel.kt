package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.world.WorldLimits
import robotran.worldediting.SheetProperties
import robotran.worldediting.WorldEdit
import robotran.worldediting.parameters

/** All properties of the world as a whole. */
@Composable
internal fun WorldPanel(editor: EditorScope, newTitle: String) {
    val parameters = editor.world.parameters
    val change = { changed: SheetProperties -> editor.make(WorldEdit.ChangeSheet(changed)) }
    TextRow(
        WorldEditorTexts.title(spoken),
        parameters.title,
        WorldLimits.MAXIMUM_TITLE_CHARACTERS,
        "field-title",
        { change(parameters.copy(title = it)) },
        editor::settle,
    )
    TextRow(
        WorldEditorTexts.task(spoken),
        parameters.task,
        WorldLimits.MAXIMUM_TASK_CHARACTERS,
        "field-task",
        { change(parameters.copy(task = it)) },
        editor::settle,
        mayBeBlank = true,
        isProse = true,
        hint = WorldEditorTexts.taskHint(spoken),
    )
    val sides = WorldLimits.MINIMUM_PAPER_SIDE..WorldLimits.MAXIMUM_PAPER_SIDE
    RowHeading(WorldEditorTexts.paper(spoken))
    NumberRow(
        WorldEditorTexts.width(spoken),
        parameters.width,
        sides,
        "field-paper-width",
        { change(parameters.copy(width = it)) },
        editor::settle,
        step = 10.0,
        unit = "cm",
    )
    NumberRow(
        WorldEditorTexts.height(spoken),
        parameters.height,
        sides,
        "field-paper-height",
        { change(parameters.copy(height = it)) },
        editor::settle,
        step = 10.0,
        unit = "cm",
    )
    RowHeading(WorldEditorTexts.room(spoken))
    NumberRow(
        WorldEditorTexts.light(spoken),
        parameters.ambientLight,
        0.0..WorldLimits.MAXIMUM_BRIGHTNESS,
        "field-light",
        { change(parameters.copy(ambientLight = it)) },
        editor::settle,
        step = 0.1,
        slider = 0f..2f,
    )
    NumberRow(
        WorldEditorTexts.temperature(spoken),
        parameters.temperature,
        WorldLimits.MINIMUM_TEMPERATURE..WorldLimits.MAXIMUM_TEMPERATURE,
        "field-temperature",
        { change(parameters.copy(temperature = it)) },
        editor::settle,
        unit = "°C",
        slider = -20f..50f,
    )
    RowHeading(WorldEditorTexts.run(spoken))
    NumberRow(
        WorldEditorTexts.timeLimit(spoken),
        parameters.timeLimit.toDouble(),
        1.0..WorldLimits.MAXIMUM_SECONDS.toDouble(),
        "field-time-limit",
        {
            change(parameters.copy(timeLimit = it.toInt()))
        },
        editor::settle,
        step = 10.0,
        unit = "s",
        isWhole = true,
        slider = 10f..300f,
    )
    NumberRow(
        WorldEditorTexts.realism(spoken),
        parameters.realism * PERCENT,
        0.0..PERCENT,
        "field-realism",
        { change(parameters.copy(realism = it / PERCENT)) },
        editor::settle,
        step = 10.0,
        unit = "%",
        slider = 0f..100f,
    )
    HelpText(WorldEditorTexts.realismHelp(spoken))
    NumberRow(
        WorldEditorTexts.seed(spoken),
        parameters.seed.toDouble(),
        0.0..Int.MAX_VALUE.toDouble(),
        "field-seed",
        { change(parameters.copy(seed = it.toInt())) },
        editor::settle,
        isWhole = true,
    )
    HelpText(WorldEditorTexts.seedHelp(spoken))
    RowHeading(WorldEditorTexts.startOver(spoken))
    WordButton(WorldEditorTexts.newWorld(spoken), "new-world", {
        editor.makeAtOnce(WorldEdit.NewWorld(newTitle))
    })
    HelpText(WorldEditorTexts.newWorldHelp(spoken))
}

private const val PERCENT = 100.0
