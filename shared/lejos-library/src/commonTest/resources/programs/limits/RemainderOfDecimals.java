public class RemainderOfDecimals {
    public static void main(String[] arguments) {
        float small = 7.5f;
        double wide = 7.5;
        small = small % 2; // refused: frem
        wide = wide % 2; // refused: drem
    }
}
