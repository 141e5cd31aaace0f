package robotran.tinyvm

import robotran.brick.program.DebuggableRun
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.HeapType
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.run.Heap
import kotlin.test.fail

/** Fails if a reference in the heap or in a static field is invalid or refers to an object of the wrong type. */
internal fun checkHeap(run: DebuggableRun) {
    val machine = (run as ThreadedRun).machine
    val heap = machine.heap
    val byDescriptor = machine.program.types.associateBy { it.descriptor }

    fun check(reference: Int, descriptor: String, where: String) {
        if (reference == 0) return
        if (!heap.isObject(reference)) fail("$where holds $reference, which is no object")
        val wanted: HeapType = byDescriptor[descriptor] ?: return
        if (isOfInterfaces(wanted)) return
        if (!heap.typeOf(
                reference,
            ).isA(wanted)
        ) {
            fail("$where holds a ${heap.typeOf(reference).descriptor} instead of a $descriptor")
        }
    }
    for (field in machine.program.statics) {
        if (field.isReference) check(machine.statics[field.slot], field.descriptor, "${field.owner.name}.${field.name}")
    }
    for (place in machine.model.firstObject until heap.words.size) {
        if (!heap.isObject(place)) continue
        when (val type = heap.typeOf(place)) {
            is LinkedClass -> generateSequence(type) { it.superclass }.flatMap { it.fields }.filter {
                !it.isStatic &&
                    it.isReference
            }
                .forEach {
                    check(heap.words[place + Heap.HEADER_WORDS + it.slot], it.descriptor, "${it.owner.name}.${it.name}")
                }

            is ArrayType -> if (type.element != null) {
                repeat(heap.length(place)) {
                    check(heap.words[place + Heap.HEADER_WORDS + it], type.elementDescriptor, type.descriptor)
                }
            }
        }
    }
}

/** Whether [type] is an interface or an array of interfaces; every object passes as those. */
private fun isOfInterfaces(type: HeapType?): Boolean = when (type) {
    is LinkedClass -> type.isInterface
    is ArrayType -> isOfInterfaces(type.element)
    null -> false
}
