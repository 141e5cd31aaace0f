package robotran.build.wasm

private const val NAME_SECTION = "name"
private const val FUNCTION_NAMES = 1

/** The names of the functions of [module] by their index, from its custom section `name`; none without that section. */
internal fun functionNames(module: WasmModule): Map<Int, String> {
    for (section in module.sections.filter { it.id == WasmModule.CUSTOM }) {
        val reader = WasmReader(section.content)
        if (reader.name() != NAME_SECTION) continue
        while (!reader.isAtEnd) {
            val kind = reader.byte()
            val length = reader.number()
            if (kind == FUNCTION_NAMES) return reader.vector { reader.number() to reader.name() }.toMap()
            reader.take(length)
        }
    }
    return emptyMap()
}
