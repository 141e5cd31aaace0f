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

/**
 * A module whose memory has data of [sizes] bytes, one after the other from address 1024 on. Its only own function copies
 * memory by the imported function of Emscripten's script, and reads a byte at the target plus 3.
 */
internal fun moduleWithData(vararg sizes: Int): WasmModule {
    val addresses = sizes.runningFold(1024, Int::plus)
    val segments = sizes.zip(addresses) { size, address ->
        WasmWriter().byte(0).constant(address).byte(0x0b).sized(ByteArray(size) { 1 }).bytes()
    }
    val code = byteArrayOf(0, 0x20, 0, 0x20, 1, 0x20, 2, 0x10, 0, 0x20, 0, 0x2d, 0, 3, 0x0b)
    return WasmModule(
        listOf(
            WasmSection(WasmModule.TYPE, byteArrayOf(2, 0x60, 3, I32, I32, I32, 0, 0x60, 3, I32, I32, I32, 1, I32)),
            WasmSection(
                WasmModule.IMPORT,
                WasmModule.vector(
                    listOf(WasmImport("env", "emscripten_memcpy_js", IndexSpace.FUNCTION, byteArrayOf(0)).bytes()),
                ),
            ),
            WasmSection(WasmModule.FUNCTIONS, byteArrayOf(1, 1)),
            WasmSection(WasmModule.MEMORY, byteArrayOf(1, 0, 2)),
            WasmSection(
                WasmModule.EXPORT,
                WasmModule.vector(listOf(WasmWriter().name("copy").byte(IndexSpace.FUNCTION.kind, 1).bytes())),
            ),
            WasmSection(WasmModule.CODE, WasmModule.vector(listOf(WasmWriter().sized(code).bytes()))),
            WasmSection(WasmModule.DATA, WasmModule.vector(segments)),
        ),
    )
}

private const val I32: Byte = 0x7f
