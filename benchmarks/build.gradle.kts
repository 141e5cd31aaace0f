plugins {
    id("robotran.benchmarks")
}

dependencies {
    implementation(project(":shared:world"))
    implementation(project(":shared:robolang"))
    implementation(libs.coroutines.core)
}

application {
    mainClass.set("robotran.benchmarks.MainKt")
}
