plugins {
    id("robotran.core")
    id("robotran.texts")
    id("robotran.mpy-cross")
}

texts {
    constant("jvmTest", "robotran.mpycompiler.sources", "shared/mpy-compiler/src/commonTest/resources/programs", "*.py")
    constant("jvmTest", "robotran.mpycompiler.compiled", "shared/hub-link/src/commonTest/resources/vectors", "mpy.txt")
}

kotlin {
    sourceSets {
        jvmMain.dependencies {
            implementation(libs.coroutines.core)
            implementation(libs.chicory.runtime)
        }
    }
}
