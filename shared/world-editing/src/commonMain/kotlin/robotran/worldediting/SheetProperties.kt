package robotran.worldediting

import robotran.world.World

/** The editable properties of a world as a whole; see [World]. */
data class SheetProperties(
    val title: String,
    val task: String,
    val width: Double,
    val height: Double,
    val ambientLight: Double,
    val temperature: Double,
    val timeLimit: Int,
    val realism: Double,
    val seed: Int,
)

val World.figures: SheetProperties
    get() = SheetProperties(title, task, paper.width, paper.height, ambientLight, temperature, timeLimit, realism, seed)

internal fun World.with(figures: SheetProperties): World = copy(
    title = figures.title,
    task = figures.task,
    paper = paper.copy(width = rounded(figures.width), height = rounded(figures.height)),
    ambientLight = rounded(figures.ambientLight),
    temperature = rounded(figures.temperature),
    timeLimit = figures.timeLimit,
    realism = rounded(figures.realism),
    seed = figures.seed,
)
