C     A program that asks whether its INTEGERs are as wide as those of
C     the FORTRAN 77 layer, as fortran/README.md says. It is built with
C     the layer of its own options and with that of others, and called
C     with the word that it must find.
      PROGRAM WIDTHS
      INTEGER I(4), N
      LOGICAL ALIKE
      CHARACTER*20 TEXT, WORD
      DO 10 N = 1, 4
        I(N) = -1
   10 CONTINUE
      CALL RCVERS(I(1), I(3), TEXT)
      ALIKE = I(1) .GT. 0 .AND. I(2) .EQ. -1
     &  .AND. I(3) .GT. 0 .AND. I(4) .EQ. -1
      CALL GET_COMMAND_ARGUMENT(1, WORD)
      WRITE (*,*) I, ALIKE, ' ', WORD
      IF (ALIKE .NEQV. WORD .EQ. 'alike') STOP 1
      END
