plugins {
    id("robotran.core")
    id("robotran.ecj-web")
}

kotlin {
    sourceSets {
        jvmMain.dependencies {
            implementation(project(":shared:ecj"))
        }
        jvmTest.dependencies {
            // Its constants are compared with ours; what runs is what shared/ecj makes of it.
            compileOnly(libs.ecj)
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
