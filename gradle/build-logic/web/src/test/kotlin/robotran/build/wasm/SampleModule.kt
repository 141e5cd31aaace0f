package robotran.build.wasm

/**
 * A module with an imported function and three own ones: one without parameters, one that returns its parameter and has
 * a local, and one that adds two numbers. They are named `none`, `same` and `sum`.
 */
internal fun sampleModule(names: List<String> = listOf("none", "same", "sum")): WasmModule {
    fun list(vararg entries: WasmWriter) = WasmModule.vector(entries.map { it.bytes() })

    fun body(vararg code: Int) = WasmWriter().sized(WasmWriter().byte(*code).bytes())
    val named = names.mapIndexed { index, name -> WasmWriter().number(index + 1).name(name) }
    val nameSection = WasmWriter().name("name").byte(1).sized(list(*named.toTypedArray())).bytes()
    return WasmModule(
        listOf(
            WasmSection(
                WasmModule.TYPE,
                list(
                    WasmWriter().byte(0x60, 0, 0),
                    WasmWriter().byte(0x60, 1, 0x7f, 1, 0x7f),
                    WasmWriter().byte(0x60, 2, 0x7f, 0x7f, 1, 0x7f),
                ),
            ),
            WasmSection(
                WasmModule.IMPORT,
                list(WasmWriter().name("env").name("tell").byte(IndexSpace.FUNCTION.kind, 0)),
            ),
            WasmSection(WasmModule.FUNCTIONS, byteArrayOf(3, 0, 1, 2)),
            WasmSection(WasmModule.TABLE, list(WasmWriter().byte(0x70, 1, 4, 4))),
            WasmSection(WasmModule.MEMORY, list(WasmWriter().byte(0, 1))),
            WasmSection(WasmModule.GLOBAL, list(WasmWriter().byte(0x7f, 1, 0x41, 7, 0x0b))),
            WasmSection(WasmModule.EXPORT, list(WasmWriter().name("sum").byte(IndexSpace.FUNCTION.kind, 3))),
            WasmSection(WasmModule.ELEMENT, list(WasmWriter().byte(0, 0x41, 1, 0x0b, 1, 2))),
            WasmSection(
                WasmModule.CODE,
                list(
                    body(0, 0x10, 0, 0x0b),
                    body(1, 1, 0x7f, 0x20, 0, 0x0b),
                    body(0, 0x20, 0, 0x20, 1, 0x6a, 0x0b),
                ),
            ),
            WasmSection(WasmModule.CUSTOM, nameSection),
        ),
    )
}
