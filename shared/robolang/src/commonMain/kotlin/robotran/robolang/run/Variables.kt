package robotran.robolang.run

import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.rom.VariableScope
import robotran.rom.VariableView

/**
 * The variables that the first of [activities] knows now: its own or those of the routine it is in, then those that the last one,
 * the main program, has declared outside all blocks.
 */
internal fun variableScopes(activities: List<Activity>): List<VariableScope> {
    val foremost = activities.first()
    val main = activities.last()
    val own = VariableScope(foremost.routine?.name ?: foremost.name, foremost.known.map { view(it, foremost) })
    if (foremost === main && main.routine == null) return listOf(own)
    return listOf(own, VariableScope(main.name, main.knownOutside.filter { it.isGlobal }.map { view(it, main) }))
}

private fun view(symbol: Symbol, activity: Activity): VariableView {
    val machine = activity.machine
    val value = if (symbol.owner == null) machine.globals[symbol.index] else activity.local(symbol.index)
    return VariableView(symbol.name, text(symbol.type, value, machine))
}

private fun text(type: ValueType, value: Int, machine: Machine): String = when (type) {
    ValueType.WHOLE, ValueType.NOTHING -> {
        value.toString()
    }

    ValueType.DECIMAL -> {
        decimalText(Float.fromBits(value))
    }

    ValueType.TRUTH -> {
        (value != 0).toString()
    }

    ValueType.LIST_OF_WHOLE, ValueType.LIST_OF_DECIMAL -> {
        machine.lists.elements(value).joinToString(", ", "[", "]") { text(type.element, it, machine) }
    }
}
