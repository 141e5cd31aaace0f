package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.ui.language.spoken
import robotran.ui.texts.WorldEditorTexts
import robotran.world.WorldLimits
import robotran.worldediting.SheetProperties
import robotran.worldediting.WorldEdit
import robotran.worldediting.figures

/** All properties of the world as a whole. */
@Composable
internal fun WorldPanel(editor: EditorScope, newTitle: String) {
    val figures = editor.world.figures
    val change = { changed: SheetProperties -> editor.make(WorldEdit.ChangeSheet(changed)) }
    TextRow(
        WorldEditorTexts.title(spoken),
        figures.title,
        WorldLimits.MAXIMUM_TITLE_CHARACTERS,
        "field-title",
        { change(figures.copy(title = it)) },
        editor::settle,
    )
    TextRow(
        WorldEditorTexts.task(spoken),
        figures.task,
        WorldLimits.MAXIMUM_TASK_CHARACTERS,
        "field-task",
        { change(figures.copy(task = it)) },
        editor::settle,
        mayBeBlank = true,
        isProse = true,
        hint = WorldEditorTexts.taskHint(spoken),
    )
    val sides = WorldLimits.MINIMUM_PAPER_SIDE..WorldLimits.MAXIMUM_PAPER_SIDE
    RowHeading(WorldEditorTexts.paper(spoken))
    NumberRow(
        WorldEditorTexts.width(spoken),
        figures.width,
        sides,
        "field-paper-width",
        { change(figures.copy(width = it)) },
        editor::settle,
        step = 10.0,
        unit = "cm",
    )
    NumberRow(
        WorldEditorTexts.height(spoken),
        figures.height,
        sides,
        "field-paper-height",
        { change(figures.copy(height = it)) },
        editor::settle,
        step = 10.0,
        unit = "cm",
    )
    RowHeading(WorldEditorTexts.room(spoken))
    NumberRow(
        WorldEditorTexts.light(spoken),
        figures.ambientLight,
        0.0..WorldLimits.MAXIMUM_BRIGHTNESS,
        "field-light",
        { change(figures.copy(ambientLight = it)) },
        editor::settle,
        step = 0.1,
        slider = 0f..2f,
    )
    NumberRow(
        WorldEditorTexts.temperature(spoken),
        figures.temperature,
        WorldLimits.MINIMUM_TEMPERATURE..WorldLimits.MAXIMUM_TEMPERATURE,
        "field-temperature",
        { change(figures.copy(temperature = it)) },
        editor::settle,
        unit = "°C",
        slider = -20f..50f,
    )
    RowHeading(WorldEditorTexts.run(spoken))
    NumberRow(
        WorldEditorTexts.timeLimit(spoken),
        figures.timeLimit.toDouble(),
        1.0..WorldLimits.MAXIMUM_SECONDS.toDouble(),
        "field-time-limit",
        {
            change(figures.copy(timeLimit = it.toInt()))
        },
        editor::settle,
        step = 10.0,
        unit = "s",
        isWhole = true,
        slider = 10f..300f,
    )
    NumberRow(
        WorldEditorTexts.realism(spoken),
        figures.realism * PERCENT,
        0.0..PERCENT,
        "field-realism",
        { change(figures.copy(realism = it / PERCENT)) },
        editor::settle,
        step = 10.0,
        unit = "%",
        slider = 0f..100f,
    )
    Remark(WorldEditorTexts.realismHelp(spoken))
    NumberRow(
        WorldEditorTexts.seed(spoken),
        figures.seed.toDouble(),
        0.0..Int.MAX_VALUE.toDouble(),
        "field-seed",
        { change(figures.copy(seed = it.toInt())) },
        editor::settle,
        isWhole = true,
    )
    Remark(WorldEditorTexts.seedHelp(spoken))
    RowHeading(WorldEditorTexts.startOver(spoken))
    WordButton(WorldEditorTexts.newWorld(spoken), "new-world", {
        editor.makeAtOnce(WorldEdit.NewWorld(newTitle))
    })
    Remark(WorldEditorTexts.newWorldHelp(spoken))
}

private const val PERCENT = 100.0
