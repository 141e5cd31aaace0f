import java.util.BitSet;
import java.util.NoSuchElementException;
import java.util.StringTokenizer;

public class BitSetsAndTokens {
    public static void main(String[] arguments) {
        BitSet sieve = new BitSet(50);
        for (int i = 2; i < 50; i++) sieve.set(i);
        for (int i = 2; i < 8; i++) {
            for (int j = i * i; j < 50; j += i) sieve.clear(j);
        }
        System.out.println(sieve); // expect {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47}
        System.out.println(sieve.get(47) + " " + sieve.get(49) + " " + sieve.get(1000)); // expect true false false
        StringTokenizer words = new StringTokenizer("drive 20 cm, then turn", " ");
        System.out.println(words.countTokens()); // expect 5
        while (words.hasMoreTokens()) System.out.println(words.nextToken()); // expect drive
        // expect 20
        // expect cm,
        // expect then
        // expect turn
        StringTokenizer numbers = new StringTokenizer("1,2,3", ",");
        int sum = 0;
        while (numbers.hasMoreTokens()) sum += Integer.parseInt(numbers.nextToken());
        System.out.println(sum); // expect 6
        try {
            numbers.nextToken();
        } catch (NoSuchElementException wrong) {
            System.out.println("no more"); // expect no more
        }
    }
}
