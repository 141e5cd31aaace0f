package robotran.simulation.light

import robotran.world.Light
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Paper
import robotran.world.geometry.Bounds
import robotran.world.geometry.Trigonometry
import robotran.world.geometry.outline
import kotlin.math.floor

/**
 * The reflectance of the floor: the paper with its marks and ink, and the floor beside it. Marks are looked up by
 * squares of the paper; each square is prepared on first use.
 */
internal class PaperSurface(private val paper: Paper, marks: List<Mark>, trigonometry: Trigonometry) {
    val ink = InkRaster(paper)
    private val prepared = marks.map { mark ->
        PreparedMark(
            mark.figure,
            (mark.figure as? MarkFigure.Area)?.shape?.outline(trigonometry),
            mark.shade,
        )
    }.reversed()

    /** The layers of each square of the paper by row and column, topmost mark first; null before first use. */
    private val squares = arrayOfNulls<Array<List<MarkLayer>?>>(indexOf(paper.height) + 1)

    /** The reflectance of the sensor's spot centred at [x], [y], 0..1. */
    fun reflectance(x: Double, y: Double): Double {
        val mayBeInked = ink.mayHave(x - SPOT, y - SPOT, x + SPOT, y + SPOT)
        val isPlain = isPlain(x, y)
        if (!mayBeInked && isPlain) return Light.PAPER
        var sum = 0.0
        for (place in SPOT_SAMPLES.indices step 2) {
            val atX = x + SPOT_SAMPLES[place]
            val atY = y + SPOT_SAMPLES[place + 1]
            sum += when {
                mayBeInked && ink.has(atX, atY) -> Light.INK
                isPlain -> Light.PAPER
                else -> withoutInk(atX, atY)
            }
        }
        return sum / (SPOT_SAMPLES.size / 2)
    }

    /** The colour of the sensor's spot centred at [x], [y]: the mean of its points. */
    fun colour(x: Double, y: Double): Tint {
        val mayBeInked = ink.mayHave(x - SPOT, y - SPOT, x + SPOT, y + SPOT)
        val isPlain = isPlain(x, y)
        if (!mayBeInked && isPlain) return PAPER_TINT
        var red = 0.0
        var green = 0.0
        var blue = 0.0
        for (place in SPOT_SAMPLES.indices step 2) {
            val atX = x + SPOT_SAMPLES[place]
            val atY = y + SPOT_SAMPLES[place + 1]
            val tint = when {
                mayBeInked && ink.has(atX, atY) -> INK_TINT
                isPlain -> PAPER_TINT
                else -> tintWithoutInk(atX, atY)
            }
            red += tint.red
            green += tint.green
            blue += tint.blue
        }
        val count = SPOT_SAMPLES.size / 2
        return Tint(red / count, green / count, blue / count)
    }

    private fun tintWithoutInk(x: Double, y: Double): Tint {
        if (!paper.contains(x, y)) return FLOOR_TINT
        val layers = layersAt(x, y)
        for (number in layers.indices) layers[number].tintAt(x, y)?.let { return it }
        return PAPER_TINT
    }

    /** Whether there are no marks near the spot, and the whole spot is on the paper. */
    private fun isPlain(x: Double, y: Double): Boolean =
        paper.contains(x - SPOT, y - SPOT) && paper.contains(x + SPOT, y + SPOT) &&
            (
                prepared.isEmpty() ||
                    (
                        isBare(x - SPOT, y - SPOT) && isBare(x + SPOT, y - SPOT) && isBare(x - SPOT, y + SPOT) &&
                            isBare(x + SPOT, y + SPOT)
                    )
            )

    private fun isBare(x: Double, y: Double) = layersAt(x, y).isEmpty()

    private fun withoutInk(x: Double, y: Double): Double {
        if (!paper.contains(x, y)) return Light.FLOOR
        val layers = layersAt(x, y)
        for (number in layers.indices) {
            val reflectance = layers[number].reflectanceAt(x, y)
            if (reflectance >= 0) return reflectance
        }
        return Light.PAPER
    }

    /** The marks of the square at a point of the paper, topmost first. */
    private fun layersAt(x: Double, y: Double): List<MarkLayer> {
        if (prepared.isEmpty()) return emptyList()
        val column = indexOf(x)
        val row = indexOf(y)
        val squaresOfRow = squares[row] ?: newRow().also { squares[row] = it }
        return squaresOfRow[column] ?: cut(column, row).also { squaresOfRow[column] = it }
    }

    private fun newRow(): Array<List<MarkLayer>?> = arrayOfNulls(indexOf(paper.width) + 1)

    private fun indexOf(place: Double): Int = floor(place / SQUARE).toInt()

    private fun cut(column: Int, row: Int): List<MarkLayer> {
        val square = Bounds(column * SQUARE, row * SQUARE, (column + 1) * SQUARE, (row + 1) * SQUARE)
        val layers = mutableListOf<MarkLayer>()
        for (mark in prepared) {
            val layer = mark.layerIn(square) ?: continue
            layers += layer
            if (layer is MarkLayer.Everywhere) break
        }
        return layers
    }

    private companion object {
        val PAPER_TINT = Tint.grey(Light.PAPER)
        val INK_TINT = Tint.grey(Light.INK)
        val FLOOR_TINT = Tint.grey(Light.FLOOR)

        /** The side of a square in centimetres. */
        const val SQUARE = 2.0

        /** The radius of the spot that the sensor lights and sees, in centimetres. */
        const val SPOT = 0.4

        /**
         * The sample points, x and y of each relative to the centre: a honeycomb of three rings, the same for every
         * heading of the robot.
         */
        val SPOT_SAMPLES: DoubleArray = honeycomb(rings = 3, step = SPOT / 3.3)

        fun honeycomb(rings: Int, step: Double): DoubleArray {
            val places = mutableListOf<Double>()
            for (row in -rings..rings) {
                for (column in maxOf(-rings, -rings - row)..minOf(rings, rings - row)) {
                    places += step * (column + row / 2.0)
                    places += step * row * HALF_ROOT_OF_THREE
                }
            }
            return places.toDoubleArray()
        }

        private const val HALF_ROOT_OF_THREE = 0.8660254037844386
    }
}
