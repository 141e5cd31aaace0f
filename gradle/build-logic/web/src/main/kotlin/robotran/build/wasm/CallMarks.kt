package robotran.build.wasm

/**
 * [module] with a byte for each function that it defines, which becomes 1 when the function is called, and behind these
 * one for each block of [LargeData], which becomes 1 when it is read: a memory of their own, exported as `called`.
 */
internal fun withCallMarks(module: WasmModule): WasmModule {
    val contents = WasmContents(module)
    val memory = contents.importsOf(IndexSpace.MEMORY).size + contents.definedIn(IndexSpace.MEMORY).count()
    val bodies = module.bodies
    val data = LargeData.of(module)
    val marks = ReadMarks(module, data, memory, firstMark = bodies.size).takeIf { data.isNotEmpty() }
    val marked = bodies.mapIndexed { index, body ->
        val reader = WasmReader(body)
        val locals = reader.copy { sameCopier(reader).locals() }
        val code = WasmReader(reader.rest())
        val copier = WasmCopier(code, marks = marks) { _, target -> target }.apply { expression() }
        locals + ReadMarks.markOf(memory, index) + copier.bytes()
    } + marks?.added.orEmpty()
    val types = marks?.types.orEmpty()
    val typesOfAdded = types.indices.map { WasmWriter().number(contents.types.count + it).bytes() }
    val pages = (bodies.size + data.sumOf { it.blocks.size }) / PAGE + 1
    val ofMarks = WasmWriter().byte(0).number(pages).bytes()
    val export = WasmWriter().name("called").byte(IndexSpace.MEMORY.kind).number(memory).bytes()
    return module.with(
        mapOf(
            WasmModule.TYPE to module.withMore(WasmModule.TYPE, types),
            WasmModule.FUNCTIONS to module.withMore(WasmModule.FUNCTIONS, typesOfAdded),
            WasmModule.MEMORY to module.withMore(WasmModule.MEMORY, listOf(ofMarks)),
            WasmModule.EXPORT to module.withMore(WasmModule.EXPORT, listOf(export)),
            WasmModule.CODE to WasmModule.vector(marked.map { WasmWriter().sized(it).bytes() }),
        ),
    )
}

private const val PAGE = 65_536
