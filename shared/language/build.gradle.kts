plugins {
    id("robotran.core")
}
