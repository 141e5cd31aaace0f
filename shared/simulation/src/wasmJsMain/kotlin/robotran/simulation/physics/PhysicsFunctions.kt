// The functions of `PhysicsModule.java` that are called in each step. They are imported from one WebAssembly module into
// the other, so no call goes through JavaScript, which would cost more than the work of most of them.

@file:OptIn(ExperimentalWasmInterop::class)

package robotran.simulation.physics

import kotlin.wasm.ExperimentalWasmInterop
import kotlin.wasm.WasmImport

/** The module that the build puts beside the generated JavaScript. */
private const val PHYSICS = "./physics.mjs"

@WasmImport(PHYSICS, "applyImpulse")
internal external fun applyImpulseTo(world: Int, body: Int, impulseX: Double, impulseY: Double, x: Double, y: Double)

@WasmImport(PHYSICS, "step")
internal external fun stepWorld(world: Int)

@WasmImport(PHYSICS, "isAtRest")
internal external fun isAtRestIn(world: Int, body: Int): Boolean

@WasmImport(PHYSICS, "x")
internal external fun xOf(world: Int, body: Int): Double

@WasmImport(PHYSICS, "y")
internal external fun yOf(world: Int, body: Int): Double

@WasmImport(PHYSICS, "cosine")
internal external fun cosineOfBody(world: Int, body: Int): Double

@WasmImport(PHYSICS, "sine")
internal external fun sineOfBody(world: Int, body: Int): Double

@WasmImport(PHYSICS, "velocityX")
internal external fun velocityXOf(world: Int, body: Int): Double

@WasmImport(PHYSICS, "velocityY")
internal external fun velocityYOf(world: Int, body: Int): Double

@WasmImport(PHYSICS, "angularVelocity")
internal external fun angularVelocityOf(world: Int, body: Int): Double

@WasmImport(PHYSICS, "contacts")
internal external fun contactsOf(world: Int, body: Int): Int

@WasmImport(PHYSICS, "freeDistance")
internal external fun freeDistanceIn(
    world: Int,
    body: Int,
    fromX: Double,
    fromY: Double,
    toX: Double,
    toY: Double,
): Double

@WasmImport(PHYSICS, "ray")
internal external fun rayIn(world: Int, body: Int, fromX: Double, fromY: Double, toX: Double, toY: Double): Double

@WasmImport(PHYSICS, "rayBody")
internal external fun rayBodyIn(world: Int): Int

@WasmImport(PHYSICS, "rayMetCircle")
internal external fun rayMetCircleIn(world: Int): Boolean

@WasmImport(PHYSICS, "rayNormalX")
internal external fun rayNormalXIn(world: Int): Double

@WasmImport(PHYSICS, "rayNormalY")
internal external fun rayNormalYIn(world: Int): Double

@WasmImport(PHYSICS, "sineOf")
internal external fun sineOf(angle: Double): Double

@WasmImport(PHYSICS, "cosineOf")
internal external fun cosineOf(angle: Double): Double

@WasmImport(PHYSICS, "angleOf")
internal external fun angleOf(x: Double, y: Double): Double
