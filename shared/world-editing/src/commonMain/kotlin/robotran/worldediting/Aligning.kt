package robotran.worldediting

import robotran.world.geometry.Bounds

/** Aligns the selected elements with each other; a single element, or a single group, with the paper. */
internal fun WorldEditing.aligned(side: AlignSide): Outcome? {
    val forms = selection.mapNotNull { thing -> world.piece(thing)?.form?.let { thing to it } }
    val blocks = forms.groupBy { (thing, _) ->
        groups.indexOfFirst { thing in it }.let {
            if (it >= 0) {
                it
            } else {
                thing
            }
        }
    }.values
    val bounds = blocks.map { block -> checkNotNull(around(block.map { it.second.bounds })) }
    val all = around(bounds) ?: return null
    val line = if (blocks.size == 1) Bounds(0.0, 0.0, world.paper.width, world.paper.height) else all
    var now = world
    for ((block, box) in blocks.zip(bounds)) {
        val (x, y) = shift(side, box, line)
        for ((thing, form) in block) {
            val piece = world.piece(thing)?.withForm(form.movedBy(x, y)) ?: continue
            errorOf(piece)?.let { return Outcome.Not(it) }
            now = now.with(thing.number, piece)
        }
    }
    return Outcome.Made(snapshot.copy(world = now))
}

private fun shift(side: AlignSide, box: Bounds, line: Bounds): Pair<Double, Double> = when (side) {
    AlignSide.LEFT -> line.left - box.left to 0.0
    AlignSide.CENTRE -> line.middle.x - box.middle.x to 0.0
    AlignSide.RIGHT -> line.right - box.right to 0.0
    AlignSide.TOP -> 0.0 to line.top - box.top
    AlignSide.MIDDLE -> 0.0 to line.middle.y - box.middle.y
    AlignSide.BOTTOM -> 0.0 to line.bottom - box.bottom
}
