package robotran.robolang.run

import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.rom.VariableScope
import robotran.rom.VariableView

/** The variables that [activity] knows now: those of the routine it is in, then those of the main program and the behaviours. */
internal fun variableScopes(activity: Activity): List<VariableScope> {
    val machine = activity.machine
    val main = VariableScope(machine.code.name, machine.code.symbols.map { view(it, machine.globals[it.index], machine) })
    val routine = activity.routine ?: return listOf(main)
    return listOf(VariableScope(routine.name, routine.symbols.map { view(it, activity.local(it.index), machine) }), main)
}

private fun view(symbol: Symbol, value: Int, machine: Machine) = VariableView(symbol.name, text(symbol.type, value, machine))

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
