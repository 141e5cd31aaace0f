package robotran.ui.brick.front

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path

/** A polygon from pairs of x and y. */
internal fun polygon(vararg places: Float): Path = Path().apply {
    for (corner in places.indices step 2) {
        if (corner == 0) moveTo(places[0], places[1]) else lineTo(places[corner], places[corner + 1])
    }
    close()
}

/** The polygon of pairs of x and y as in `0 1, 2.5 4`, measured from [origin]. */
internal fun polygon(places: String, origin: Offset): Path {
    val numbers = places.split(' ', ',').filter { it.isNotEmpty() }.map { it.toFloat() }
    return polygon(*FloatArray(numbers.size) { numbers[it] + if (it % 2 == 0) origin.x else origin.y })
}
