package robotran.worldediting

import robotran.editing.rounded
import robotran.json.nearestDecimal
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Shade

/** The mark with its numbers rounded as in a file. */
internal fun Mark.tidied(): Mark {
    val shade = when (val shade = shade) {
        is Shade.Grey -> Shade.Grey(nearestDecimal(shade.reflectance))
        is Shade.Colour -> shade
    }
    val figure = when (val figure = figure) {
        is MarkFigure.Line -> figure.copy(width = rounded(figure.width))
        is MarkFigure.Area, is MarkFigure.GreyMap -> figure
    }
    return copy(shade = shade, figure = figure)
}
