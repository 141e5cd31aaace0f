public class HugeArraysAgainAndAgain {
    static int[][][] cube;

    public static void main(String[] arguments) {
        while (true) {
            try {
                cube = new int[500][500][500];
            } catch (Throwable full) {
                cube = null;
            }
        }
    }
}
// runs on after 500
