package robotran.build.wasm

/** What [module] imports and defines, by [IndexSpace] and index. The imports of a space come first in it. */
internal class WasmContents(module: WasmModule) {
    val types = WasmTypes(module)
    val exports: List<WasmExport> = module.exports
    val start: Int? = module[WasmModule.START]?.let { WasmReader(it).number() }
    private val imports: Map<IndexSpace, List<WasmImport>> = module.imports.groupBy { it.space }
    private val functionTypes: List<Int> = module.entries(WasmModule.FUNCTIONS) { number() }
    private val definitions: Map<IndexSpace, List<ByteArray>> = mapOf(
        IndexSpace.FUNCTION to module.bodies,
        IndexSpace.TABLE to module.entries(WasmModule.TABLE) { copy { sameCopier(this).tableType() } },
        IndexSpace.MEMORY to module.entries(WasmModule.MEMORY) { copy { sameCopier(this).limits() } },
        IndexSpace.TAG to module.entries(WasmModule.TAG) { copy { sameCopier(this).tagType() } },
        IndexSpace.GLOBAL to module.entries(WasmModule.GLOBAL) { copy { sameCopier(this).global() } },
        IndexSpace.ELEMENT to module.entries(WasmModule.ELEMENT) { copy { sameCopier(this).elements() } },
        IndexSpace.DATA to module.entries(WasmModule.DATA) { copy { sameCopier(this).data() } },
    )

    fun importsOf(space: IndexSpace): List<WasmImport> = imports[space].orEmpty()

    /** All indices of [space] that the module itself defines. */
    fun definedIn(space: IndexSpace): IntRange {
        val first = importsOf(space).size
        return first until first + definitions.getValue(space).size
    }

    /** The definition of what is [index] in [space], as it stands in the module. */
    fun definition(space: IndexSpace, index: Int): ByteArray =
        definitions.getValue(space)[index - importsOf(space).size]

    /** The type of the function [index] that the module defines. */
    fun typeOf(index: Int): Int = functionTypes[index - importsOf(IndexSpace.FUNCTION).size]

    /** Whether the segment [index] in [space] is written into a table or memory when the module is instantiated. */
    fun isActive(space: IndexSpace, index: Int): Boolean =
        WasmReader(definition(space, index)).number() and WasmCopier.PASSIVE == 0

    /** Copies what is known of [index] in [space] outside the module: its type, as in an import. */
    fun copyType(space: IndexSpace, index: Int, indices: IndexMap): ByteArray {
        val import = importsOf(space).getOrNull(index)
        val bytes = when {
            import != null -> import.type
            space == IndexSpace.FUNCTION -> WasmWriter().number(typeOf(index)).bytes()
            else -> definition(space, index)
        }
        return WasmCopier(WasmReader(bytes), indices = indices).apply { importType(space) }.bytes()
    }

    /** Copies the definition of what is [index] in [space]. */
    fun copyDefinition(space: IndexSpace, index: Int, indices: IndexMap): ByteArray =
        WasmCopier(WasmReader(definition(space, index)), indices = indices).apply {
            when (space) {
                IndexSpace.FUNCTION -> body()
                IndexSpace.TABLE -> tableType()
                IndexSpace.MEMORY -> limits()
                IndexSpace.TAG -> tagType()
                IndexSpace.GLOBAL -> global()
                IndexSpace.ELEMENT -> elements()
                IndexSpace.DATA -> data()
                else -> error("The module defines no $space by itself.")
            }
        }.bytes()
}
