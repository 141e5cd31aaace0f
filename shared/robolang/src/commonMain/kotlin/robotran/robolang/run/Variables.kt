package robotran.robolang.run

import robotran.brick.program.VariableScope
import robotran.brick.program.VariableView
import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType

/**
 * The variables in scope at [frame] of the call stacks of [activities] in a row, 0 being the innermost frame: those of
 * that routine, behaviour or main program, then the globals of the main program, the last of [activities]. Empty if
 * there is no such frame.
 */
internal fun variableScopes(activities: List<Activity>, frame: Int): List<VariableScope> {
    var within = frame
    val activity = activities.firstOrNull { each ->
        (within < each.frameCount).also { isHere -> if (!isHere) within -= each.frameCount }
    } ?: return emptyList()
    val main = activities.last()
    val own = VariableScope(activity.frames()[within].name, activity.knownAt(within).map { view(it, activity, within) })
    val outermost = main.frameCount - 1
    if (activity === main && within == outermost) return listOf(own)
    val outside = main.knownAt(outermost).filter { it.isGlobal }
    return listOf(own, VariableScope(main.name, outside.map { view(it, main, outermost) }))
}

private fun view(symbol: Symbol, activity: Activity, frame: Int): VariableView {
    val machine = activity.machine
    val value = if (symbol.owner == null) machine.globals[symbol.index] else activity.local(symbol.index, frame)
    return VariableView(symbol.name, text(symbol.type, value, machine))
}

private fun text(type: ValueType, value: Int, machine: InterpreterState): String = when (type) {
    ValueType.WHOLE, ValueType.NOTHING -> value.toString()
    ValueType.DECIMAL -> decimalText(Float.fromBits(value))
    ValueType.TRUTH -> (value != 0).toString()
    ValueType.COLOUR -> colourName(value).lowercase()

    ValueType.LIST_OF_WHOLE, ValueType.LIST_OF_DECIMAL -> {
        machine.lists.elements(value).joinToString(", ", "[", "]") { text(type.element, it, machine) }
    }
}
