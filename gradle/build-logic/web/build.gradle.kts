plugins {
    id("java-gradle-plugin")
    id("org.jetbrains.kotlin.jvm")
}

dependencies {
    implementation(project(":jvm"))
    implementation(project(":compose"))
    // Only the worker that compiles to Wasm needs it at run time.
    compileOnly(libs.teavm.tooling)
    testImplementation(libs.kotlin.test)
}

tasks.test {
    useJUnitPlatform()
}

gradlePlugin {
    testSourceSets()
    plugins {
        create("webTools") {
            id = "robotran.web-tools"
            implementationClass = "robotran.build.WebToolsPlugin"
        }
        create("wasm") {
            id = "robotran.wasm"
            implementationClass = "robotran.build.WasmPlugin"
        }
        create("wasmTests") {
            id = "robotran.wasm-tests"
            implementationClass = "robotran.build.WasmTestsPlugin"
        }
        create("physicsModule") {
            id = "robotran.physics-module"
            implementationClass = "robotran.build.teavm.PhysicsModulePlugin"
        }
        create("ecjModule") {
            id = "robotran.ecj-module"
            implementationClass = "robotran.build.teavm.EcjModulePlugin"
        }
        create("web") {
            id = "robotran.web"
            implementationClass = "robotran.build.WebAppPlugin"
        }
        create("benchmarks") {
            id = "robotran.benchmarks"
            implementationClass = "robotran.build.BenchmarksPlugin"
        }
    }
}
