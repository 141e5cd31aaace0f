plugins {
    id("application")
    id("org.jetbrains.kotlin.jvm")
}

dependencies {
    implementation(project(":shared:robolang"))
    implementation(project(":shared:world"))
    implementation(project(":shared:physics"))
    implementation(libs.coroutines.core)
}

application {
    mainClass.set("robotran.benchmarks.MainKt")
}
