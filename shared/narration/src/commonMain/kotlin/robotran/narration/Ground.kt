package robotran.narration

import robotran.simulation.state.SessionState
import robotran.world.Goal
import robotran.world.HasRegion
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.RegionRole
import robotran.world.Shade
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.flat

/** What the sheet has at a spot. */
internal data class Ground(val kind: GroundKind, val name: String? = null, val tone: Tone? = null)

/** What is on the sheet at [point], from top to bottom; never empty. Things that stand there are no part of it. */
internal fun groundAt(world: World, session: SessionState, point: Point): List<Ground> {
    if (!world.paper.contains(point.x, point.y)) return listOf(Ground(GroundKind.TABLE))
    val sheet = SheetReader(world)
    val found = buildList {
        if (sheet.hasInk(session.ink, point)) add(Ground(GroundKind.INK, tone = Tone.BLACK))
        sheet.markAt(point)?.let { add(groundOf(it)) }
        if (world.template?.strokes.orEmpty().any { isOn(it, point, LINE_REACH) }) add(Ground(GroundKind.TEMPLATE))
        for (region in regionsOf(world.goals)) {
            if (flat(region.region).contains(point.x, point.y)) add(Ground(region.kind))
        }
    }
    return found.distinct().take(MAX_GROUNDS).ifEmpty { listOf(Ground(GroundKind.PAPER)) }
}

internal fun groundOf(mark: Mark): Ground = when (mark.figure) {
    is MarkFigure.Area -> Ground(GroundKind.AREA, mark.name, mark.shade.tone)
    is MarkFigure.Line -> Ground(GroundKind.LINE, mark.name, mark.shade.tone)
    is MarkFigure.GreyMap -> Ground(GroundKind.PICTURE, mark.name)
}

/** The conditions about places among [goals] and their parts. */
internal fun regionsOf(goals: List<Goal>): List<HasRegion> =
    goals.flatMap { goal -> (goal.condition as? HasRegion)?.let(::listOf) ?: regionsOf(goal.parts) }

private val HasRegion.kind: GroundKind
    get() = when (role) {
        RegionRole.TARGET -> GroundKind.TARGET
        RegionRole.FORBIDDEN -> GroundKind.FORBIDDEN
        RegionRole.PERMITTED -> GroundKind.PERMITTED
    }

internal val Shade.tone: Tone
    get() = when (this) {
        is Shade.Grey -> grey(reflectance)

        is Shade.Colour -> {
            val most = maxOf(red, green, blue)
            when {
                most - minOf(red, green, blue) < FAINT -> grey(most / WHITE)
                most == blue -> Tone.BLUE
                most == green && red < green * YELLOWISH -> Tone.GREEN
                green < red * YELLOWISH -> Tone.RED
                else -> Tone.YELLOW
            }
        }
    }

private fun grey(lightness: Double): Tone = when {
    lightness < DARK -> Tone.BLACK
    lightness < BRIGHT -> Tone.GREY
    else -> Tone.WHITE
}

/** How near to a drawing a finger is on it, in centimetres. */
private const val LINE_REACH = 0.4
private const val MAX_GROUNDS = 3

/** Of 255: colours whose parts differ by less look grey. */
private const val FAINT = 40
private const val WHITE = 255.0
private const val YELLOWISH = 0.7
private const val DARK = 0.3
private const val BRIGHT = 0.75
