public class LongArithmetic {
    public static void main(String[] arguments) {
        long number = System.currentTimeMillis();
        number = number + 1; // refused: ladd
        number = number - 1; // refused: lsub
        number = number * 2; // refused: lmul
        number = number / 2; // refused: ldiv
        number = number % 2; // refused: lrem
        number = -number; // refused: lneg
        number = number << 2; // refused: lshl
        number = number >> 2; // refused: lshr
        number = number >>> 2; // refused: lushr
        number = number & 2; // refused: land
        number = number | 2; // refused: lor
        number = number ^ 2; // refused: lxor
        boolean isLate = number > 5; // refused: lcmp
    }
}
