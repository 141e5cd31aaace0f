plugins {
    id("java-gradle-plugin")
    alias(libs.plugins.kotlin.jvm)
}

dependencies {
    implementation(libs.plugin.kotlin)
    implementation(libs.plugin.android)
    implementation(libs.plugin.android.builder) // for R8
    implementation(libs.apksig)
    implementation(libs.animal.sniffer)
    implementation(libs.dexlib)
    implementation(libs.plugin.kotlin.compose)
    implementation(libs.plugin.compose)
    implementation(libs.plugin.kotlin.serialization)
    implementation(libs.asm)
    // Only the workers that compile to Wasm and for the brick need these at run time.
    compileOnly(libs.teavm.tooling)
    compileOnly(libs.ecj)
    testImplementation(libs.kotlin.test)
}

tasks.test {
    useJUnitPlatform()
}

gradlePlugin {
    testSourceSets() // none: the tests are plain unit tests, and an embedded Gradle has no TestKit
    plugins {
        create("root") {
            id = "robotran.root"
            implementationClass = "robotran.build.RootPlugin"
        }
        create("core") {
            id = "robotran.core"
            implementationClass = "robotran.build.CorePlugin"
        }
        create("compose") {
            id = "robotran.compose"
            implementationClass = "robotran.build.ComposePlugin"
        }
        create("web") {
            id = "robotran.web"
            implementationClass = "robotran.build.WebAppPlugin"
        }
        create("benchmarks") {
            id = "robotran.benchmarks"
            implementationClass = "robotran.build.BenchmarksPlugin"
        }
        create("jvmApp") {
            id = "robotran.jvm-app"
            implementationClass = "robotran.build.JvmAppPlugin"
        }
        create("desktop") {
            id = "robotran.desktop"
            implementationClass = "robotran.build.DesktopPlugin"
        }
        create("physics") {
            id = "robotran.physics"
            implementationClass = "robotran.build.physics.PhysicsPlugin"
        }
        create("physicsWeb") {
            id = "robotran.physics-web"
            implementationClass = "robotran.build.physics.PhysicsWebPlugin"
        }
        create("ecj") {
            id = "robotran.ecj"
            implementationClass = "robotran.build.ecj.EcjPlugin"
        }
        create("ecjWeb") {
            id = "robotran.ecj-web"
            implementationClass = "robotran.build.ecj.EcjWebPlugin"
        }
        create("texts") {
            id = "robotran.texts"
            implementationClass = "robotran.build.texts.TextsPlugin"
        }
        create("lejosLibrary") {
            id = "robotran.lejos-library"
            implementationClass = "robotran.build.lejos.LejosLibraryPlugin"
        }
        create("brickPrograms") {
            id = "robotran.brick-programs"
            implementationClass = "robotran.build.lejos.BrickProgramsPlugin"
        }
        create("android") {
            id = "robotran.android"
            implementationClass = "robotran.build.android.AndroidPlugin"
        }
        create("androidApp") {
            id = "robotran.android.app"
            implementationClass = "robotran.build.android.AndroidAppPlugin"
        }
    }
}
