package robotran.nqc.api

import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.config.ParameterLimit

internal val BOTH = setOf(FirmwareTarget.RCX, FirmwareTarget.RCX2)
internal val FIRST = setOf(FirmwareTarget.RCX)
internal val SECOND = setOf(FirmwareTarget.RCX2)

/** Lists the entries of one [group]. */
internal class ApiBuilder(private val group: NqcApiGroup) {
    private val entries = mutableListOf<NqcApiEntry>()

    fun build(): List<NqcApiEntry> = entries.toList()

    /** @param declaration the function's head: `SetPower(const int outputs, const int &power)`. */
    fun function(
        declaration: String,
        body: String,
        help: ApiHelp,
        vararg limits: ParameterLimit?,
        targets: Set<FirmwareTarget> = BOTH,
    ) {
        val name = declaration.substringBefore('(')
        val parameters = declaration.substringAfter('(').substringBeforeLast(')')
        val names = parameters.split(',').map { it.trim().substringAfterLast(' ').removePrefix("&") }
        val definition = ApiDefinition.Function(parameters, body, limits.asList())
        add(name, NqcApiKind.FUNCTION, names.filter { it.isNotEmpty() }, targets, definition, help)
    }

    /** @param head such as `Timer(n)`. */
    fun value(head: String, text: String, help: ApiHelp, targets: Set<FirmwareTarget> = BOTH) {
        val parameters = if ('(' in head) head.substringAfter('(').substringBefore(')') else null
        val names = parameters?.split(',')?.map { it.trim() }?.filter { it.isNotEmpty() }
        add(head.substringBefore('('), NqcApiKind.VALUE, names, targets, ApiDefinition.Text(text), help)
    }

    /** Constants such as `OUT_A=1 OUT_B=2`, separated by blanks, with one sentence about all of them. */
    fun constants(list: String, help: ApiHelp, targets: Set<FirmwareTarget> = BOTH) = list.split(' ').forEach {
        val text = ApiDefinition.Text(it.substringAfter('='))
        add(it.substringBefore('='), NqcApiKind.CONSTANT, null, targets, text, help)
    }

    private fun add(
        name: String,
        kind: NqcApiKind,
        parameters: List<String>?,
        targets: Set<FirmwareTarget>,
        definition: ApiDefinition,
        help: ApiHelp,
    ) {
        entries += NqcApiEntry(name, kind, group, parameters, targets, definition, help)
    }
}

internal fun api(group: NqcApiGroup, build: ApiBuilder.() -> Unit): List<NqcApiEntry> =
    ApiBuilder(group).apply(build).build()
