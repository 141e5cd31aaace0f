package robotran.nqc.generate

import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.AssemblyField
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Place
import robotran.nqc.tree.Statement

/** Generates the bytes of `asm`. */
internal class AssemblyEmitter(private val emitter: Emitter, private val values: ValueEmitter) {
    fun emit(statement: Statement.Assembly, frame: FrameLayout) {
        val instantiation = Instantiation(emitter, frame)
        val places = statement.fields.map { field ->
            val value = instantiation.of(field.value)
            when (field) {
                is AssemblyField.Byte -> byte(value)
                is AssemblyField.Operand -> operand(field, value)
            }
        }
        val bytes = statement.fields.zip(places).flatMap { (field, place) -> bytesOf(field, place) }
        emitter.sensors.noteCommand(bytes, isOwn = frame.call == null)
        emitter.addBytes(*bytes.toIntArray())
        places.forEach { emitter.release(it) }
    }

    private fun byte(value: Expression): Place {
        val constant = value.constant
        if (constant != null) return Emitter.constant(constant)
        // Says what else is wrong with the value, if it is one that is always constant.
        if (value.isPromisedConstant) return values.any(value)
        emitter.report(NqcDiagnosticCode.CONSTANT_NEEDED, value.range, emitter.sink.messages.constantNeeded())
        return Emitter.constant(0)
    }

    private fun operand(field: AssemblyField.Operand, value: Expression): Place =
        values.constrained(value, field.allowsLocals) { type ->
            field.sources == 0 || (type < SOURCE_BITS && field.sources shr type and 1 != 0)
        }

    private fun bytesOf(field: AssemblyField, place: Place): List<Int> = when (field) {
        is AssemblyField.Byte -> listOf(Emitter.low(place.data))

        is AssemblyField.Operand -> listOfNotNull(
            if (field.hasNoType) null else place.type,
            Emitter.low(place.data),
            if (field.isSmall) null else Emitter.high(place.data),
        )
    }

    private companion object {
        /** The sources that a restriction has bits for. */
        const val SOURCE_BITS = 24
    }
}
