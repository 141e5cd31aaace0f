plugins {
    id("robotran.core")
    id("robotran.physics-web")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:simulation"))
        }
        commonTest.dependencies {
            implementation(project(":shared:robolang"))
        }
        jvmTest {
            kotlin.srcDir("../world/src/arbitraryWorlds/kotlin")
        }
        wasmJsMain.dependencies {
            implementation(libs.coroutines.core)
        }
    }
}
