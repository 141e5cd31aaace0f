@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.simulation.physics

import kotlin.js.Promise

/** The functions of `PhysicsModule.java`, compiled to WebAssembly; worlds, bodies and fixtures are numbers. */
internal external interface PhysicsModule : JsAny {
    fun createWorld(
        stepSeconds: Double,
        stepParts: Int,
        lengthTolerance: Double,
        velocityIterations: Int,
        positionIterations: Int,
    ): Int

    fun closeWorld(world: Int)

    fun addBody(world: Int, kind: Int, x: Double, y: Double, angle: Double): Int

    fun addPolygon(world: Int, body: Int, corners: JsAny, friction: Double): Int

    fun addCircle(world: Int, body: Int, x: Double, y: Double, radius: Double, friction: Double): Int

    fun spreadMass(world: Int, body: Int, mass: Double)

    fun addFloorFriction(world: Int, body: Int, force: Double, torque: Double)

    fun place(world: Int, body: Int, x: Double, y: Double, angle: Double)

    fun setMass(world: Int, body: Int, x: Double, y: Double, mass: Double, inertia: Double)

    fun applyImpulse(world: Int, body: Int, impulseX: Double, impulseY: Double, x: Double, y: Double)

    fun step(world: Int)

    fun x(world: Int, body: Int): Double

    fun y(world: Int, body: Int): Double

    fun cosine(world: Int, body: Int): Double

    fun sine(world: Int, body: Int): Double

    fun velocityX(world: Int, body: Int): Double

    fun velocityY(world: Int, body: Int): Double

    fun angularVelocity(world: Int, body: Int): Double

    fun contacts(world: Int, body: Int): Int

    fun freeDistance(world: Int, body: Int, fromX: Double, fromY: Double, toX: Double, toY: Double): Double

    fun sineOf(angle: Double): Double

    fun cosineOf(angle: Double): Double

    fun angleOf(x: Double, y: Double): Double
}

/** A dynamic import, so that the module is fetched on demand, and so that bundlers find it. */
internal fun importPhysicsModule(): Promise<PhysicsModule> =
    js("import('./physics.mjs').then(module => module.loadModule())")

internal fun DoubleArray.toJsArray(): JsAny = newFloat64Array(size).also { copy ->
    forEachIndexed { place, value -> put(copy, place, value) }
}

private fun newFloat64Array(size: Int): JsAny = js("new Float64Array(size)")

private fun put(array: JsAny, place: Int, value: Double): Unit = js("{ array[place] = value; }")
