package robotran.robotediting

import robotran.world.BumperPart
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.length
import robotran.world.robot.RobotError
import robotran.world.robot.RobotPiece
import robotran.world.robot.brickSeat
import robotran.world.robot.chassisCorners
import robotran.world.robot.corners
import robotran.world.robot.things
import kotlin.math.abs

/**
 * What is within [reach] of [point], small things first: a finger on the brick may mean a sensor beside it. Of sensors
 * over each other, the upper one comes first, which is the one that is seen.
 */
fun RobotDescription.elementsAt(point: Point, reach: Double): List<RobotElement> =
    elements().mapNotNull { element -> distance(element, point)?.takeIf { it <= reach }?.let { element to it } }
        .sortedWith(
            compareBy({ (element, _) ->
                rank(element)
            }, { (_, distance) -> distance }, { (element, _) -> -top(element) }, { (element, _) ->
                placeOf(element)?.let { beyond(it, 0.0, point) } ?: 0.0
            }),
        )
        .map { (element, _) -> element }

/** The piece that [error] is about; null if it is about the whole robot. */
fun RobotDescription.elementOf(error: RobotError): RobotElement? = when (error.piece) {
    RobotPiece.PART -> error.part?.let(::thingOfEntry)?.let { RobotElement.Part(it) }
    RobotPiece.WHEELS -> RobotElement.Wheels
    RobotPiece.CASTERS -> if (casters.isEmpty()) RobotElement.Mass else RobotElement.Caster(0)
    RobotPiece.PEN -> RobotElement.Pen.takeIf { pen != null }
    RobotPiece.BRICK -> RobotElement.Brick
    RobotPiece.MASS -> RobotElement.Mass
    RobotPiece.OUTLINE, RobotPiece.HEIGHT -> RobotElement.Chassis
    RobotPiece.ALL -> null
}

/** How high a sensor lies, in centimetres. Other things lie below, or beside it. */
private fun RobotDescription.top(element: RobotElement): Double =
    ((element as? RobotElement.Part)?.let { things[it.number] } as? SensorPart)?.height ?: 0.0

private fun rank(element: RobotElement): Int = when (element) {
    is RobotElement.Part, is RobotElement.Caster, is RobotElement.Corner -> 0
    RobotElement.Pen, RobotElement.Mass -> 1
    RobotElement.Wheels -> 2
    RobotElement.Brick -> 3
    RobotElement.Chassis -> 4
}

/** 0 on the element; null if it cannot be touched. */
private fun RobotDescription.distance(element: RobotElement, point: Point): Double? = when (element) {
    is RobotElement.Part -> {
        when (val part = things[element.number]) {
            is BumperPart -> outside(part.corners, point)
            is SensorPart -> outside(SensorBody.of(part.sensor, brick).corners(part), point)
            else -> null
        }
    }

    is RobotElement.Caster -> beyond(casters[element.number], CASTER, point)
    is RobotElement.Corner -> beyond(chassis.outline[element.number], 0.0, point)
    RobotElement.Pen -> beyond(Point(0.0, 0.0), CASTER, point)
    RobotElement.Mass -> beyond(chassis.massAt, 0.0, point)

    RobotElement.Wheels -> {
        val beside = abs(abs(point.y) - drive.track / 2) - drive.wheelWidth / 2
        maxOf(beside, abs(point.x) - drive.wheelDiameter / 2, 0.0)
    }

    RobotElement.Brick -> {
        brickSeat.let { seat ->
            maxOf(abs(point.x - seat.middle.x) - seat.halfAlong, abs(point.y - seat.middle.y) - seat.halfAcross, 0.0)
        }
    }

    RobotElement.Chassis -> outside(chassisCorners, point)
}

private fun outside(corners: List<Point>, point: Point): Double =
    Outline.Angular(corners).let { if (it.contains(point.x, point.y)) 0.0 else it.distanceToEdge(point.x, point.y) }

private fun beyond(at: Point, radius: Double, point: Point): Double =
    maxOf(length(point.x - at.x, point.y - at.y) - radius, 0.0)

/** Half the size of a caster or a pen on the plan, in centimetres. */
private const val CASTER = 0.8
