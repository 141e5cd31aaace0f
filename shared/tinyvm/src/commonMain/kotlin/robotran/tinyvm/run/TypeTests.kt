package robotran.tinyvm.run

import robotran.tinyvm.config.Quirk
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.LinkedClass

/** Tests the types of objects at run time. */
internal class TypeTests(private val machine: VirtualMachine) {
    private val types = machine.program.types
    private val isBrick = machine.model.hasQuirks
    private val isExact = machine.model.isExact

    /**
     * Whether the object [reference], not null, passes as the type [typeId]. On a brick, every object passes as an
     * interface.
     */
    fun isInstance(reference: Int, typeId: Int): Boolean {
        val target = types[typeId]
        val isReally = machine.heap.typeOf(reference).isA(target)
        if (isReally || isExact || target !is LinkedClass || !target.isInterface) return isReally
        machine.addWarning(Quirk.UNCHECKED_INTERFACE)
        return isBrick
    }

    /** Whether [reference] may be stored in [array]; both are not null. */
    fun mayStore(array: Int, reference: Int): Boolean {
        val element = (machine.heap.typeOf(array) as ArrayType).element ?: return false
        val type = machine.heap.typeOf(reference)
        if (isExact) return type.isA(element)
        return type === element || (element is LinkedClass && element.isInterface) || type.isA(element)
    }
}
