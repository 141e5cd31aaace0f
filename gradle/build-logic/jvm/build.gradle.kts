plugins {
    id("java-gradle-plugin")
    id("org.jetbrains.kotlin.jvm")
}

dependencies {
    api(libs.plugin.kotlin)
    implementation(libs.plugin.kotlin.serialization)
    implementation(libs.asm)
    // Only the worker that compiles for the brick needs it at run time.
    compileOnly(libs.ecj)
    testImplementation(libs.kotlin.test)
}

tasks.test {
    useJUnitPlatform()
}

gradlePlugin {
    testSourceSets() // none: the tests are plain unit tests, and an embedded Gradle has no TestKit
    plugins {
        create("core") {
            id = "robotran.core"
            implementationClass = "robotran.build.CorePlugin"
        }
        create("jvmLibrary") {
            id = "robotran.jvm-library"
            implementationClass = "robotran.build.JvmLibraryPlugin"
        }
        create("jvmApp") {
            id = "robotran.jvm-app"
            implementationClass = "robotran.build.JvmAppPlugin"
        }
        create("physics") {
            id = "robotran.physics"
            implementationClass = "robotran.build.physics.PhysicsPlugin"
        }
        create("physicsWeb") {
            id = "robotran.physics-web"
            implementationClass = "robotran.build.teavm.PhysicsWebPlugin"
        }
        create("ecj") {
            id = "robotran.ecj"
            implementationClass = "robotran.build.ecj.EcjPlugin"
        }
        create("ecjWeb") {
            id = "robotran.ecj-web"
            implementationClass = "robotran.build.teavm.EcjWebPlugin"
        }
        create("nxjWeb") {
            id = "robotran.nxj-web"
            implementationClass = "robotran.build.teavm.NxjWebPlugin"
        }
        create("texts") {
            id = "robotran.texts"
            implementationClass = "robotran.build.texts.TextsPlugin"
        }
        create("languages") {
            id = "robotran.languages"
            implementationClass = "robotran.build.messages.LanguagesPlugin"
        }
        create("lejosLibrary") {
            id = "robotran.lejos-library"
            implementationClass = "robotran.build.lejos.LejosLibraryPlugin"
        }
        create("nxjLibrary") {
            id = "robotran.nxj-library"
            implementationClass = "robotran.build.lejos.NxjLibraryPlugin"
        }
        create("mpyCross") {
            id = "robotran.mpy-cross"
            implementationClass = "robotran.build.mpy.MpyCrossPlugin"
        }
        create("brickPrograms") {
            id = "robotran.brick-programs"
            implementationClass = "robotran.build.lejos.BrickProgramsPlugin"
        }
    }
}
